// The one interface of every metric.
//
// A metric is a folder under metrics/ with a `metric.cpp` that defines, for a folder `my_metric`,
// `isobench::Metric isobench::metric_my_metric()`. CMake finds the folder, compiles every .cpp in it and lists the
// function in a generated registry. README.md has a complete example.
//
// The declaration is the only place that names a figure: results.csv, run.json, tables, LaTeX macros, claims,
// `isobench list` and `isobench compare` read it from here.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "isobench/metrics/histogram.h"

namespace isobench {

/// What a metric needs besides the mesh. If that is not given, the metric's figures are "not measured".
enum class Needs {
  mesh,     ///< nothing
  surface,  ///< the isosurface F = c
  sizing,   ///< the sizing field that the mesh was asked for
};

/// When a metric is measured.
enum class When {
  always,
  on_request,  ///< it takes seconds: runs of an experiment without `metrics_of_use` leave it out
};

enum class Kind {
  number,
  count,    ///< a whole number of at least 0
  integer,  ///< a whole number of either sign
};

/// When `isobench compare` takes two values of a figure as equal.
enum class Compared {
  within_tolerance,  ///< they differ by no more than --tolerance, relative to the larger one
  exactly,           ///< they are equal, whatever the tolerance
};

enum class Better { neither, larger, smaller };

/// Values of FigureDeclaration::column.
inline constexpr int no_column = 0;
inline constexpr int cost_columns = 500;  ///< smaller numbers are left of the columns of seconds and memory
inline constexpr int last_column = 1000;

struct FigureDeclaration {
  std::string name{};        ///< a-z, 0-9 and _; unique among the figures of all metrics
  std::string unit{};        ///< "mm", "%"; "" for none
  std::string definition{};  ///< one or more sentences
  Kind kind = Kind::number;
  Compared compared = Compared::within_tolerance;
  Better better = Better::neither;
  /// Which meshes have no such figure; follows "Not measured where", for example "the mesh is not closed". "" for none.
  std::string unmeasured{};
  /// Columns of results.csv are sorted by this number, then by the order of declared_figures(). The columns that the
  /// first versions had keep their numbers; a new one has last_column. no_column: not in results.csv.
  int column = last_column;
};

/// A histogram with its bins. A histogram of whole numbers has no bins declared: bin n counts the value n, and there
/// are as many as the largest value needs.
struct HistogramDeclaration {
  std::string name{};
  double low = 0.0;
  double high = 0.0;
  std::size_t bins = 0;

  Histogram empty() const { return {low, high, bins}; }
};

class Measurement;
class MetricInput;
class MetricOutput;

/// What the pictures of a field show of each mesh.
enum class FieldView {
  whole,
  mark,  ///< the marked place, close up
};

/// Which runs of a data set have pictures of a field.
enum class FieldRuns {
  all,              ///< if one mesh has the field, those without it are drawn, too, in grey
  first_and_worst,  ///< the first method, and the one with the worst FieldDeclaration::judged_by
};

enum class FieldScale {
  linear,       ///< from 0
  logarithmic,  ///< from a thousandth of the brightest colour's value; smaller values look like it
};

/// An array of the mesh that reports draw, method beside method with the same view and the same colours. The metric
/// keeps it with add_vertex_data() or add_triangle_data(). Where no mesh has it, there are no pictures.
struct FieldDeclaration {
  std::string name{};         ///< of the array; a-z, 0-9 and _; unique among the fields of all metrics
  std::string title{};        ///< the heading over the pictures
  std::string legend{};       ///< what the colours show, with the unit; a few words
  std::string explanation{};  ///< one or more sentences below the heading
  /// The value of the brightest colour; by default 1 % of the values of one mesh are above it, and fewer of the others.
  std::optional<double> brightest{};
  FieldScale scale = FieldScale::linear;
  FieldView view = FieldView::whole;
  FieldRuns runs = FieldRuns::all;
  std::string judged_by{};  ///< a figure that has `better`; also says which mesh is worst
  /// The figures <mark>_x, <mark>_y and <mark>_z are a place, mm, in the frame of the stored mesh; "" for none.
  std::string mark{};
  std::string stage{};  ///< the seconds of this stage of the run are printed below a picture; "" for none
  /// What is printed below the picture of a mesh.
  std::string (*caption)(const Measurement& measurement) = nullptr;
};

struct Metric {
  std::string name{};  ///< the folder's
  Needs needs = Needs::mesh;
  When when = When::always;
  /// The monitor's stage that its seconds are booked to; "" for a stage of the metric's name.
  std::string stage{};
  /// Every run.json has these figures; a record that lacks one is damaged. Leave it false for a new metric: in records
  /// that are older than the metric its figures are unknown.
  bool in_every_record = false;
  std::vector<FigureDeclaration> figures{};
  std::vector<HistogramDeclaration> histograms{};
  std::vector<FieldDeclaration> fields{};
  /// Sets the figures that it can measure; the others stay "not measured". Called only if `needs` is given.
  void (*measure)(MetricInput& input, MetricOutput& output) = nullptr;
};

/// All metrics, in the order of their first columns in results.csv, then of their names.
const std::vector<Metric>& metrics();

/// Sorts any list in that order. Throws std::logic_error if a figure, histogram or field is declared twice, or a
/// declaration is incomplete.
std::vector<Metric> sorted_and_checked(std::vector<Metric> metrics);

/// The figures of all metrics, in the metrics' order.
const std::vector<FigureDeclaration>& declared_figures();
const std::vector<HistogramDeclaration>& declared_histograms();
const std::vector<FieldDeclaration>& declared_fields();

/// The index of a figure in declared_figures(). Throws std::logic_error, with the nearest name, if no metric declares
/// it: the name is misspelt in the program's own code.
std::size_t figure_index(std::string_view name);
std::size_t histogram_index(std::string_view name);
const FigureDeclaration& declared_figure(std::string_view name);

/// The metrics that declare the n-th figure and the n-th histogram.
const Metric& metric_of_figure(std::size_t index);
const Metric& metric_of_histogram(std::size_t index);

/// The definition, followed by "Not measured where …" if some meshes have no such figure.
std::string full_definition(const FigureDeclaration& figure);

}  // namespace isobench
