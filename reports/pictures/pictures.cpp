#include "isobench/reports/pictures/pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "isobench/foundation/files/scratch_folder.h"
#include "isobench/foundation/files/whole_files.h"
#include "isobench/foundation/processes/run_command.h"
#include "isobench/foundation/sha256.h"
#include "isobench/reports/pictures/field_pictures.h"
#include "isobench/reports/pictures/render.h"
#include "isobench/reports/runs/refinement.h"
#include "isobench/reports/runs/run_grid.h"
#include "isobench/reports/survey/survey.h"
#include "isobench/reports/tables/sizing_grid.h"
#include "isobench/reports/text/markdown.h"

namespace isobench {

namespace {

namespace fs = std::filesystem;

// Nobody looks at more pictures, and each one makes the page larger.
constexpr std::size_t most_of_a_dataset = 24;
constexpr std::size_t most_meshes = 72;
constexpr std::size_t most_triangles = 20000;          // of one mesh that the page shows in 3D
constexpr std::size_t most_triangles_of_all = 800000;  // of all of them; twelve bytes each

void add_run(PictureGroup& group, const RunRecord& run, const std::string& name) {
  group.runs.push_back(&run);
  group.names.push_back(name);
}

std::size_t meshes_on(const RunGrid& runs, const std::string& dataset) {
  return static_cast<std::size_t>(
      std::count_if(runs.variants.begin(), runs.variants.end(), [&dataset](const Variant& variant) {
        const RunRecord* run = find_run(variant, dataset);
        return run != nullptr && run->status == Status::ok;
      }));
}

// Of a method with several sizings only the finest meshes, unless all are few enough.
RunGrid drawn_runs(const Results& results, std::vector<std::string>& left_out) {
  RunGrid all = arrange_runs(results);
  std::size_t meshes = 0;
  bool too_many = false;
  for (const std::string& dataset : all.datasets) {
    const std::size_t here = meshes_on(all, dataset);
    meshes += here;
    too_many = too_many || here > most_of_a_dataset || meshes > most_meshes;
  }
  RunGrid finest = finest_runs(all);
  if (!too_many || finest.variants.size() == all.variants.size()) return all;
  left_out.push_back(fmt::format(
      "Pictures show the finest mesh of each method on each data set; all {} meshes would be too many.", meshes));
  return finest;
}

PictureGroup dataset_group(const RunGrid& runs, const std::string& dataset, std::size_t most,
                           std::vector<std::string>& left_out) {
  PictureGroup group;
  group.dataset = group.title = dataset;
  for (const Variant& variant : runs.variants) {
    const RunRecord* run = find_run(variant, dataset);
    if (run == nullptr || run->status != Status::ok) continue;
    if (group.runs.size() < std::min(most, most_of_a_dataset)) add_run(group, *run, variant.name);
  }
  const std::size_t meshes = meshes_on(runs, dataset);
  if (meshes > group.runs.size()) {
    left_out.push_back(group.runs.empty() ? fmt::format("{}: none of {} meshes has a picture.", dataset, meshes)
                                          : fmt::format("{}: only the first {} of {} meshes have pictures.", dataset,
                                                        group.runs.size(), meshes));
  }
  return group;
}

// With many data sets pictures are made of the one that the page opens with, and of the worst mesh of each method.
std::vector<PictureGroup> chosen_groups(const RunGrid& runs, std::vector<std::string>& left_out) {
  constexpr std::size_t most_worst = 6;
  std::vector<PictureGroup> groups;
  const std::string opening = opening_dataset(runs);
  if (!opening.empty()) groups.push_back(dataset_group(runs, opening, most_meshes, left_out));
  std::size_t worst_meshes = 0;
  for (const Variant* method : surveyed(runs)) {
    const RunRecord* run = worst_case(runs, *method, quality_criterion("radius-ratio-min")).run;
    if (run == nullptr || run->request.dataset == opening || ++worst_meshes > most_worst) continue;
    const std::string& dataset = run->request.dataset;
    auto group = std::find_if(groups.begin(), groups.end(),
                              [&dataset](const PictureGroup& known) { return known.dataset == dataset; });
    if (group == groups.end()) {
      group = groups.emplace(group);
      group->dataset = group->title = dataset;
    }
    add_run(*group, *run, method->name);
  }
  left_out.push_back(fmt::format(
      "Pictures and meshes in 3D show {} of {} data sets: the one at the top of the page and those with the "
      "worst triangle of a method.",
      groups.size(), runs.datasets.size()));
  return groups;
}

PictureGroup grid_group(const SizingGrid& grid) {
  PictureGroup group;
  group.dataset = grid.dataset;
  group.title = fmt::format("{}, {}: grid of ε (rows) and δ (columns)", grid.dataset, grid.label);
  group.grid = true;
  group.across = grid.deltas.size();
  for (const double epsilon : grid.epsilons) {
    for (const double delta : grid.deltas) {
      const auto cell = grid.cells.find({epsilon, delta});
      if (cell == grid.cells.end()) continue;
      const auto done = std::find_if(cell->second.begin(), cell->second.end(),
                                     [](const RunRecord* run) { return run->status == Status::ok; });
      if (done != cell->second.end()) add_run(group, **done, fmt::format("ε {}, δ {}", epsilon, delta));
    }
  }
  return group;
}

// Artefacts are files beside the mesh of a run.
bool kept(const fs::path& folder, const RunRecord& run, const char* artefact) {
  return run.request.artefacts && fs::exists(folder / run.request.run / artefact);
}

bool all_there(const PictureGroup& group, const fs::path& folder) {
  return std::all_of(group.runs.begin(), group.runs.end(), [&](const RunRecord* run) {
    const std::vector<std::string> files = files_of(group, *run, folder);
    return std::all_of(files.begin(), files.end(), [&](const std::string& file) { return fs::exists(folder / file); });
  });
}

std::string caption_of(const RunRecord& run, const std::string& shot) {
  if (shot == shots::closer) return "close up";
  if (shot == shots::whole) return fmt::format("{} triangles", run.measurement->number("triangles"));
  if (shot == shots::worst) return "radius ratio " + significant(run.measurement->number("radius_ratio_min"), 3);
  if (shot == shots::medial_axis)
    return "the medial axis inside the surface, coloured by its distance to the surface, mm";
  if (shot == shots::initial_sizing) return "h0, the longest edge that the sampling theory allows, mm";
  if (shot == shots::limited_sizing) return "h, which is h0 with its growth limited, mm";
  return "the particles before they are connected";
}

const std::vector<std::pair<const char*, const char*>>& titles() {
  static const std::vector<std::pair<const char*, const char*>> all = {
      {shots::whole, "the whole mesh"},
      {shots::closer, "the same place, close up"},
      {shots::worst, "the worst triangle of each mesh"},
      {shots::medial_axis, "the medial axis"},
      {shots::initial_sizing, "the initial sizing field"},
      {shots::limited_sizing, "the limited sizing field"},
      {shots::particles, "the particles"},
      {shots::particles_closer, "the particles, close up"}};
  return all;
}

void list_pictures(const PictureGroup& group, const fs::path& folder, Pictures& pictures) {
  for (const auto& [shot, title] : titles()) {
    for (std::size_t n = 0; n < group.runs.size(); ++n) {
      const RunRecord& run = *group.runs[n];
      const std::vector<std::string> wanted = shots_of(group, run, folder);
      if (std::find(wanted.begin(), wanted.end(), shot) == wanted.end()) continue;
      Picture picture{group.file(run, shot),
                      group.file(run, shot, "jpg"),
                      group.dataset,
                      run.request.run,
                      shot,
                      group.grid,
                      group.title,
                      group.names[n],
                      caption_of(run, shot),
                      ""};
      if (!group.grid) picture.group += std::string(": ") + title;
      if (fs::exists(folder / picture.file) && fs::exists(folder / picture.preview))
        pictures.pictures.push_back(std::move(picture));
    }
  }
}

void list_others(const PictureGroup& group, const fs::path& folder, Pictures& pictures) {
  if (group.grid) return;
  for (std::size_t n = 0; n < group.runs.size(); ++n) {
    const RunRecord& run = *group.runs[n];
    for (const char* name : {PictureGroup::turn, PictureGroup::turn_worst}) {
      const std::string file = group.file(run, name, "mesh");
      if (!fs::exists(folder / file)) continue;
      pictures.turnable.push_back({file, group.dataset, group.names[n], run.request.run,
                                   name == std::string(PictureGroup::turn_worst),
                                   static_cast<std::size_t>(run.measurement->number("triangles"))});
    }
    const fs::path counts = folder / group.file(run, PictureGroup::over_h, "txt");
    if (!fs::exists(counts)) continue;
    EdgesOverH edges{group.dataset, group.names[n], {}};
    std::istringstream text(read_text(counts));
    for (std::uint32_t count = 0; text >> count;) edges.counts.push_back(count);
    pictures.edges_over_h.push_back(std::move(edges));
  }
}

void remove_others(const std::vector<PictureGroup>& groups, const fs::path& folder) {
  std::set<std::string> names;
  for (const PictureGroup& group : groups) {
    for (const RunRecord* run : group.runs) {
      for (const std::string& file : files_of(group, *run, folder)) names.insert(fs::path(file).filename().string());
    }
  }
  std::vector<fs::path> others;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder / "pictures")) {
    if (!names.contains(entry.path().filename().string())) others.push_back(entry.path());
  }
  for (const fs::path& other : others) fs::remove_all(other);
}

// Runs the drawing program. Returns what it could not draw, one sentence a line of its output.
std::vector<std::string> run_drawing_program(const fs::path& folder) {
  const fs::path program = fs::read_symlink("/proc/self/exe").parent_path() / "isobench-pictures";
  if (!fs::exists(program)) return {"Pictures cannot be drawn: " + program.string() + " is missing; build it."};
  const ScratchFolder scratch(folder);
  const bool ended_well = run_tool({program.string(), fs::absolute(folder).string()}, scratch.path());
  std::vector<std::string> sentences;
  std::istringstream log(read_text_or_empty(scratch.path() / "log.txt"));
  for (std::string line; std::getline(log, line);) sentences.push_back(line);
  if (!ended_well && sentences.empty())
    sentences.emplace_back("isobench-pictures, the program that draws pictures, crashed.");
  return sentences;
}

}  // namespace

std::string PictureGroup::file(const RunRecord& run, const std::string& name, const char* ending) const {
  const std::string hash = sha256_of_text(key + " " + run.mesh_checksum + " " + name).substr(0, 8);
  return fmt::format("pictures/{}-{}-{}.{}", run.request.run, name, hash, ending);
}

std::vector<PictureGroup> picture_groups(const Results& results, std::vector<std::string>& left_out) {
  const RunGrid runs = drawn_runs(results, left_out);
  const bool many = has_many_datasets(arrange_runs(results));  // as the rest of the page sees it
  std::vector<PictureGroup> groups;
  if (many) groups = chosen_groups(runs, left_out);
  std::size_t meshes = 0;
  for (const PictureGroup& group : groups) meshes += group.runs.size();
  for (const std::string& dataset : many ? std::vector<std::string>() : runs.datasets) {
    groups.push_back(dataset_group(runs, dataset, most_meshes - meshes, left_out));
    meshes += groups.back().runs.size();
  }
  // With many data sets the page has much else to load.
  const std::size_t of_all = many ? most_triangles_of_all / 4 : most_triangles_of_all;
  const std::size_t triangles =
      std::clamp(of_all / std::max<std::size_t>(meshes, 1), std::size_t{1000}, most_triangles);
  for (const SizingGrid& grid : sizing_grids(results)) {
    if (grid.epsilons.size() * grid.deltas.size() <= most_of_a_dataset) groups.push_back(grid_group(grid));
  }
  std::erase_if(groups, [](const PictureGroup& group) { return group.runs.empty(); });
  for (PictureGroup& group : groups) {
    group.turnable_triangles = triangles;
    group.key = fmt::format("{} {} {}", render_revision, group.grid ? "grid" : "", triangles);
    for (const RunRecord* run : group.runs) group.key += " " + run->mesh_checksum;
  }
  return groups;
}

std::vector<std::string> shots_of(const PictureGroup& group, const RunRecord& run, const fs::path& folder) {
  if (group.grid) return {shots::whole};
  std::vector<std::string> all = {shots::whole, shots::closer, shots::worst};
  if (kept(folder, run, "medial-axis.vtp")) all.emplace_back(shots::medial_axis);
  if (kept(folder, run, "sizing.vtp")) all.insert(all.end(), {shots::initial_sizing, shots::limited_sizing});
  if (kept(folder, run, "particles.vtp")) all.insert(all.end(), {shots::particles, shots::particles_closer});
  for (const FieldPictures& of : field_pictures(group, folder)) {
    const bool drawn =
        std::any_of(of.runs.begin(), of.runs.end(), [&](std::size_t n) { return group.runs[n] == &run; });
    if (drawn) all.push_back(of.shot);
  }
  return all;
}

std::vector<std::string> files_of(const PictureGroup& group, const RunRecord& run, const fs::path& folder) {
  std::vector<std::string> files;
  for (const std::string& shot : shots_of(group, run, folder)) {
    files.push_back(group.file(run, shot));
    files.push_back(group.file(run, shot, "jpg"));
  }
  if (group.grid) return files;
  files.push_back(group.file(run, PictureGroup::turn, "mesh"));
  if (run.measurement->number("triangles") > static_cast<double>(group.turnable_triangles))
    files.push_back(group.file(run, PictureGroup::turn_worst, "mesh"));
  if (kept(folder, run, "sizing.vtp")) files.push_back(group.file(run, PictureGroup::over_h, "txt"));
  return files;
}

Pictures make_pictures(const Results& results, const fs::path& folder) {
  Pictures pictures;
  fs::create_directories(folder / "pictures");
  const std::vector<PictureGroup> groups = picture_groups(results, pictures.missing);
  const auto complete = [&folder](const PictureGroup& group) { return all_there(group, folder); };
  if (!std::all_of(groups.begin(), groups.end(), complete)) {
    for (std::string& sentence : run_drawing_program(folder)) pictures.missing.push_back(std::move(sentence));
  }
  remove_others(groups, folder);
  for (const PictureGroup& group : groups) {
    if (group.grid) pictures.across = group.across;
    list_pictures(group, folder, pictures);
    list_fields(group, folder, pictures.pictures);
    list_others(group, folder, pictures);
  }
  return pictures;
}

}  // namespace isobench
