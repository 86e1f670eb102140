#include "isobench/reports/pictures/field_pictures.h"

#include <fmt/format.h>

#include <algorithm>

#include "isobench/methods/mesh_files/mesh_files.h"
#include "isobench/reports/text/markdown.h"

namespace isobench {

namespace {

// Whether the first figure is worse. A figure that was not measured is never worse.
bool is_worse(const FieldDeclaration& field, const RunRecord& a, const RunRecord& b) {
  const double of_a = a.measurement->number(field.judged_by);
  const double of_b = b.measurement->number(field.judged_by);
  return declared_figure(field.judged_by).better == Better::smaller ? of_a > of_b : of_a < of_b;
}

std::vector<std::size_t> first_and_worst(const FieldDeclaration& field, const PictureGroup& group,
                                         const std::vector<std::size_t>& having) {
  if (having.size() < 2) return having;
  const auto worst = std::max_element(having.begin() + 1, having.end(), [&](std::size_t a, std::size_t b) {
    return is_worse(field, *group.runs[b], *group.runs[a]);
  });
  return {having.front(), *worst};
}

// The runs that were measured like those that have the field.
std::vector<std::size_t> all_measured(const FieldDeclaration& field, const PictureGroup& group) {
  std::vector<std::size_t> runs;
  for (std::size_t n = 0; n < group.runs.size(); ++n) {
    if (group.runs[n]->measurement->is_known(figure_index(field.judged_by))) runs.push_back(n);
  }
  return runs;
}

std::vector<std::size_t> runs_of(const FieldDeclaration& field, const PictureGroup& group,
                                 const std::vector<std::size_t>& having) {
  if (having.empty()) return {};
  if (field.runs == FieldRuns::first_and_worst) return first_and_worst(field, group, having);
  return field.view == FieldView::mark || field.judged_by.empty() ? having : all_measured(field, group);
}

}  // namespace

std::vector<FieldPictures> field_pictures(const PictureGroup& group, const std::filesystem::path& folder) {
  std::vector<FieldPictures> all;
  if (group.grid) return all;
  std::vector<std::set<std::string>> names;
  for (const RunRecord* run : group.runs) names.push_back(data_names(folder / run->request.run / "mesh.vtp"));
  for (const FieldDeclaration& field : declared_fields()) {
    std::vector<std::size_t> having;
    for (std::size_t n = 0; n < names.size(); ++n) {
      if (names[n].contains(field.name)) having.push_back(n);
    }
    FieldPictures pictures{&field, "field-" + field.name, runs_of(field, group, having)};
    if (!pictures.runs.empty()) all.push_back(std::move(pictures));
  }
  // Simulations first, then errors.
  std::stable_partition(all.begin(), all.end(),
                        [](const FieldPictures& of) { return of.field->runs == FieldRuns::all; });
  return all;
}

std::string caption_of(const FieldDeclaration& field, const RunRecord& run) {
  std::string words = field.caption(*run.measurement);
  const auto stage = std::find_if(run.stages.begin(), run.stages.end(),
                                  [&field](const StageTime& each) { return each.name == field.stage; });
  // The stages are those of the run, also if a later program measured it again.
  if (stage != run.stages.end() && !run.measured_again)
    words += fmt::format(", {} s", significant(stage->wall_seconds, 2));
  return words;
}

void list_fields(const PictureGroup& group, const std::filesystem::path& folder, std::vector<Picture>& pictures) {
  for (const FieldPictures& of : field_pictures(group, folder)) {
    for (const std::size_t n : of.runs) {
      const RunRecord& run = *group.runs[n];
      Picture picture{group.file(run, of.shot),
                      group.file(run, of.shot, "jpg"),
                      group.dataset,
                      run.request.run,
                      of.shot,
                      false,
                      group.title + ": " + of.field->title,
                      group.names[n],
                      caption_of(*of.field, run),
                      of.field->explanation};
      if (std::filesystem::exists(folder / picture.file) && std::filesystem::exists(folder / picture.preview))
        pictures.push_back(std::move(picture));
    }
  }
}

}  // namespace isobench
