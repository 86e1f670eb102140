// The declarations of the metrics.
#include "isobench/metrics/metric.h"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

#include "isobench/metrics/metric_input.h"

namespace isobench {

namespace {

void measure_nothing(MetricInput& /*input*/, MetricOutput& /*output*/) {}

Metric sample_metric(const std::string& name, const std::string& figure) {
  Metric metric;
  metric.name = name;
  metric.figures = {{.name = figure, .definition = "What it is."}};
  metric.measure = measure_nothing;
  return metric;
}

std::string complaint(const std::vector<Metric>& all) {
  try {
    sorted_and_checked(all);
  } catch (const std::logic_error& error) {
    return error.what();
  }
  return "";
}

TEST(Metrics, DeclareEveryFigureOnceWithADefinition) {
  EXPECT_EQ(complaint(metrics()), "");  // metrics() itself throws if the registry is wrong
  std::set<std::string> names;
  for (const FigureDeclaration& figure : declared_figures()) {
    EXPECT_TRUE(names.insert(figure.name).second) << figure.name << " is declared twice";
    EXPECT_GT(figure.definition.size(), 20U) << figure.name;
    EXPECT_EQ(figure.definition.back(), '.') << figure.name;
    EXPECT_EQ(figure.unit == "%", figure.name.ends_with("_percent")) << figure.name;
    EXPECT_TRUE(!figure.name.ends_with("_count") || figure.kind == Kind::count) << figure.name;
  }
  std::set<int> columns;
  for (const FigureDeclaration& figure : declared_figures()) {
    if (figure.column == no_column || figure.column == last_column) continue;
    EXPECT_TRUE(columns.insert(figure.column).second) << figure.name << " has the number of another column";
  }
}

TEST(Metrics, AFigureThatIsDeclaredTwiceIsRefusedByName) {
  EXPECT_EQ(complaint({sample_metric("a", "size"), sample_metric("b", "weight")}), "");
  EXPECT_EQ(complaint({sample_metric("a", "size"), sample_metric("b", "size")}),
            "the figure size is declared twice, by the metrics a and b");
  Metric twice = sample_metric("a", "size");
  twice.figures.push_back(twice.figures.front());
  EXPECT_EQ(complaint({twice}), "the figure size is declared twice, by the metrics a and a");
  Metric histogram = sample_metric("b", "weight");
  histogram.histograms = {{.name = "angle"}, {.name = "angle"}};
  EXPECT_EQ(complaint({histogram}), "the histogram angle is declared twice, by the metrics b and b");
}

TEST(Metrics, IncompleteDeclarationsAreRefused) {
  Metric metric = sample_metric("a", "size");
  metric.figures[0].definition = "no sentence";
  EXPECT_NE(complaint({metric}).find("does not define its figure size"), std::string::npos);
  EXPECT_NE(complaint({sample_metric("a", "Size mm")}).find("'Size mm'"), std::string::npos);
  metric = sample_metric("a", "size");
  metric.measure = nullptr;
  EXPECT_NE(complaint({metric}).find("no function"), std::string::npos);
}

std::string no_caption(const Measurement& /*measurement*/) { return ""; }

TEST(Metrics, FieldsAreDeclaredWholeAndOnce) {
  Metric metric = sample_metric("a", "size");
  metric.fields = {
      {.name = "heat", .title = "Heat", .legend = "°C", .explanation = "How warm it is.", .caption = no_caption}};
  EXPECT_EQ(complaint({metric}), "");
  Metric other = sample_metric("b", "weight");
  other.fields = metric.fields;
  EXPECT_EQ(complaint({metric, other}), "the field heat is declared twice, by the metrics a and b");
  metric.fields[0].explanation = "no sentence";
  EXPECT_NE(complaint({metric}).find("does not declare its field 'heat' with"), std::string::npos);
  for (const FieldDeclaration& field : declared_fields()) {
    if (!field.judged_by.empty()) {
      EXPECT_NE(declared_figure(field.judged_by).better, Better::neither) << field.name;
    }
    if (field.mark.empty()) continue;
    for (const char* axis : {"_x", "_y", "_z"}) EXPECT_EQ(declared_figure(field.mark + axis).unit, "mm") << field.name;
  }
}

TEST(Metrics, AreInTheOrderOfTheirColumnsAndNewOnesComeLast) {
  std::vector<Metric> sorted = metrics();
  sorted.push_back(sample_metric("zzz", "new_figure"));
  sorted = sorted_and_checked(sorted);
  EXPECT_EQ(sorted.front().name, "mesh_size");
  EXPECT_EQ(sorted.back().name, "zzz");
}

TEST(Metrics, AMisspeltNameThrowsWithTheNearestOne) {
  EXPECT_EQ(declared_figure("radius_ratio_min").name, "radius_ratio_min");
  try {
    figure_index("radius_ratio_mni");
    FAIL() << "found";
  } catch (const std::logic_error& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean 'radius_ratio_min'?"), std::string::npos) << error.what();
  }
  EXPECT_THROW(histogram_index("angles"), std::logic_error);
}

TEST(Metrics, SetOnlyWhatTheyDeclare) {
  Measurement measurement;
  TriangleMesh mesh;
  MetricOutput output(metrics().front(), measurement, mesh);
  output.set("vertices", 3.0);
  EXPECT_EQ(measurement.figure("vertices"), 3.0);
  EXPECT_THROW(output.set("euler", 2.0), std::logic_error);
  EXPECT_THROW(output.set("vertcies", 3.0), std::logic_error);
  EXPECT_THROW(output.set("angle", Histogram(0.0, 1.0, 2)), std::logic_error);
  EXPECT_THROW(output.add_vertex_data("x", {1.0}), std::logic_error);
}

}  // namespace

}  // namespace isobench
