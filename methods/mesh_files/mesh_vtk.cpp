// Legacy VTK files (VTK File Formats, versions 1 to 5.1 of the format): PolyData and UnstructuredGrid, as text or in
// big-endian binary. Data arrays behind the cells are not read.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <map>
#include <optional>
#include <set>

#include "isobench/foundation/text.h"
#include "isobench/methods/mesh_files/mesh_bytes.h"
#include "isobench/methods/mesh_files/mesh_formats.h"
#include "isobench/methods/mesh_files/mesh_text.h"
#include "isobench/methods/mesh_files/vtk_cells.h"

namespace isobench {

namespace {

constexpr std::string_view blank_characters = " \t\r\n\v\f";

/// A type of numbers in binary files.
struct VtkNumber {
  std::size_t bytes;
  double (*take)(std::string_view&);
};

template <typename Number>
constexpr VtkNumber big_endian() {
  return {sizeof(Number),
          [](std::string_view& bytes) { return static_cast<double>(take_number<Number>(bytes, std::endian::big)); }};
}

std::optional<VtkNumber> number_type(const std::string& name) {
  static const std::map<std::string, VtkNumber> types = {{"char", big_endian<std::int8_t>()},
                                                         {"signed_char", big_endian<std::int8_t>()},
                                                         {"unsigned_char", big_endian<std::uint8_t>()},
                                                         {"short", big_endian<std::int16_t>()},
                                                         {"unsigned_short", big_endian<std::uint16_t>()},
                                                         {"int", big_endian<std::int32_t>()},
                                                         {"unsigned_int", big_endian<std::uint32_t>()},
                                                         {"vtkidtype", big_endian<std::int32_t>()},
                                                         {"long", big_endian<std::int64_t>()},
                                                         {"unsigned_long", big_endian<std::uint64_t>()},
                                                         {"vtktypeint64", big_endian<std::int64_t>()},
                                                         {"vtktypeuint64", big_endian<std::uint64_t>()},
                                                         {"float", big_endian<float>()},
                                                         {"double", big_endian<double>()}};
  const auto found = types.find(lower_case(name));
  return found == types.end() ? std::nullopt : std::optional(found->second);
}

/// The words and numbers of a legacy file, in their order.
class VtkScanner {
 public:
  VtkScanner(std::string_view bytes, std::filesystem::path path) : rest_(bytes), path_(std::move(path)) {}

  std::string_view line() {
    const std::string_view line = rest_.substr(0, rest_.find('\n'));
    rest_.remove_prefix(std::min(line.size() + 1, rest_.size()));
    return line.ends_with('\r') ? line.substr(0, line.size() - 1) : line;
  }
  /// The next word; "" at the end of the file.
  std::string_view word() {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(blank_characters), rest_.size()));
    const std::string_view word = rest_.substr(0, rest_.find_first_of(blank_characters));
    rest_.remove_prefix(word.size());
    return word;
  }
  std::string keyword() { return lower_case(std::string(word().substr(0, 100))); }
  std::size_t count() {
    const std::string_view text = word();
    const std::optional<long> number = to_integer(text);
    if (!number || *number < 0)
      fail(fmt::format("damaged: '{}' is found where a number of points or cells is expected", text));
    return static_cast<std::size_t>(*number);
  }
  /// Whether `next` is the next word; it is taken then.
  bool take(std::string_view next) {
    const std::string_view before = rest_;
    if (keyword() == next) return true;
    rest_ = before;
    return false;
  }
  void set_binary(bool binary) { binary_ = binary; }
  /// Binary numbers begin behind the line that announces them.
  void end_announcement() {
    if (binary_) line();
  }
  std::vector<double> numbers(std::size_t count, const std::string& type_name) {
    const std::optional<VtkNumber> type = number_type(type_name);
    if (!type) fail(fmt::format("its numbers of type '{}' cannot be read", type_name));
    // Compared before memory is taken. A number in a text has at least a digit and a blank.
    if (count > (binary_ ? rest_.size() / type->bytes : (rest_.size() + 1) / 2)) truncated();
    std::vector<double> numbers;
    numbers.reserve(count);
    while (numbers.size() < count) numbers.push_back(binary_ ? type->take(rest_) : number());
    return numbers;
  }
  [[noreturn]] void fail(const std::string& message) const { bad_mesh(path_, message); }
  [[noreturn]] void truncated() const { fail("is truncated: it has less data than it announces; copy it again"); }

 private:
  double number() {
    const std::string_view text = word();
    if (text.empty()) truncated();
    const std::optional<double> number = to_number(text);
    if (!number) fail(fmt::format("'{}' is not a number", text));
    return *number;
  }

  std::string_view rest_;
  std::filesystem::path path_;
  bool binary_ = false;
};

/// Reads the parts of a file up to its data arrays.
class LegacyReader {
 public:
  LegacyReader(std::string_view bytes, const std::filesystem::path& path)
      : scanner_(bytes, path), adder_(mesh_, path) {}

  PolygonMesh read() {
    read_header();
    while (read_part()) {
    }
    if (grid_ && !types_read_ && !cells_.ends.empty()) scanner_.fail("is truncated: its cells have no types");
    adder_.add_notes();
    return std::move(mesh_);
  }

 private:
  void read_header() {
    scanner_.line();  // "# vtk DataFile Version 3.0"
    scanner_.line();  // the title
    const std::string mode = scanner_.keyword();
    if (mode != "ascii" && mode != "binary") {
      scanner_.fail(fmt::format("damaged: '{}' is found where ASCII or BINARY is expected", mode));
    }
    scanner_.set_binary(mode == "binary");
  }

  /// False at the end of what is read.
  bool read_part() {
    const std::string keyword = scanner_.keyword();
    if (keyword.empty() || keyword == "point_data" || keyword == "cell_data") return false;
    if (keyword == "dataset") {
      read_kind();
    } else if (keyword == "field") {
      skip_field();
    } else if (keyword == "metadata") {
      skip_metadata();
    } else if (keyword == "points") {
      read_points();
    } else if (keyword == "cells" && grid_) {
      cells_ = read_cells();
    } else if (keyword == "cell_types" && grid_) {
      read_types();
    } else if (const auto type = cell_type(keyword); type && !grid_) {
      adder_.add(read_cells(), *type);
    } else {
      scanner_.fail(fmt::format("damaged: '{}' is found where a part of a mesh is expected", keyword));
    }
    return true;
  }

  static std::optional<VtkCellType> cell_type(const std::string& keyword) {
    if (keyword == "vertices") return VtkCellType::vertex;
    if (keyword == "lines") return VtkCellType::line;
    if (keyword == "polygons") return VtkCellType::polygon;
    if (keyword == "triangle_strips") return VtkCellType::strip;
    return std::nullopt;
  }

  void read_kind() {
    const std::string kind = scanner_.keyword();
    grid_ = kind == "unstructured_grid";
    if (grid_ || kind == "polydata") return;
    const bool volume = kind == "structured_points" || kind == "structured_grid" || kind == "rectilinear_grid";
    scanner_.fail(volume ? fmt::format("holds a volume ({}), not a mesh; give a mesh", kind)
                         : fmt::format("holds '{}'; only polydata and unstructured_grid can be read", kind));
  }

  void read_points() {
    if (!mesh_.vertices.empty()) scanner_.fail("has points twice; export it again");
    const std::size_t count = scanner_.count();
    const std::string type(scanner_.word().substr(0, 100));
    scanner_.end_announcement();
    const std::vector<double> coordinates = scanner_.numbers(saturating(count, 3), type);
    for (std::size_t v = 0; v < count; ++v) mesh_.vertices.emplace_back(coordinates.data() + 3 * v);
  }

  /// Cells are either lists, each behind its length, or, since version 5, two arrays.
  VtkCells read_cells() {
    const std::size_t count = scanner_.count();
    const std::size_t size = scanner_.count();
    scanner_.end_announcement();
    if (scanner_.take("offsets")) return read_arrays(count, size);
    const std::vector<double> lists = scanner_.numbers(size, "int");
    VtkCells cells;
    for (std::size_t at = 0; at < lists.size();) {
      const double length = lists[at++];
      if (!(length >= 0.0) || length > static_cast<double>(lists.size() - at)) {
        scanner_.fail("damaged: a cell has more corners than there are; copy or export it again");
      }
      const auto begin = lists.begin() + static_cast<std::ptrdiff_t>(at);
      cells.corners.insert(cells.corners.end(), begin, begin + static_cast<std::ptrdiff_t>(length));
      at += static_cast<std::size_t>(length);
      cells.ends.push_back(static_cast<double>(cells.corners.size()));
    }
    if (cells.ends.size() != count) {
      scanner_.fail(
          fmt::format("damaged: it announces {} cells and has {}; copy or export it again", count, cells.ends.size()));
    }
    return cells;
  }

  VtkCells read_arrays(std::size_t offsets, std::size_t corners) {
    VtkCells cells;
    const std::string type(scanner_.word().substr(0, 100));
    scanner_.end_announcement();
    cells.ends = scanner_.numbers(offsets, type);
    if (!cells.ends.empty()) cells.ends.erase(cells.ends.begin());  // the first offset is 0
    if (!scanner_.take("connectivity")) scanner_.fail("damaged: it has offsets of cells, but not their corners");
    const std::string corner_type(scanner_.word().substr(0, 100));
    scanner_.end_announcement();
    cells.corners = scanner_.numbers(corners, corner_type);
    return cells;
  }

  void read_types() {
    const std::size_t count = scanner_.count();
    scanner_.end_announcement();
    const std::vector<double> types = scanner_.numbers(count, "int");
    if (types.size() != cells_.ends.size() || types_read_) {
      scanner_.fail(fmt::format("damaged: it has {} cells and {} types of cells; copy or export it again",
                                cells_.ends.size(), types.size()));
    }
    types_read_ = true;
    adder_.add(cells_, types);
  }

  void skip_field() {
    scanner_.word();  // its name
    const std::size_t arrays = scanner_.count();
    for (std::size_t n = 0; n < arrays; ++n) {
      while (scanner_.take("metadata")) skip_metadata();
      if (scanner_.word().empty()) scanner_.truncated();
      const std::size_t components = scanner_.count();
      const std::size_t tuples = scanner_.count();
      const std::string type(scanner_.word().substr(0, 100));
      scanner_.end_announcement();
      scanner_.numbers(saturating(tuples, components), type);
    }
  }

  /// Lines of text up to an empty one, also in binary files.
  void skip_metadata() {
    scanner_.line();
    while (!scanner_.line().empty()) {
    }
  }

  /// A product that is too large becomes a number that no file holds.
  static std::size_t saturating(std::size_t a, std::size_t b) {
    constexpr std::size_t most = std::size_t{1} << 60U;
    return b > 0 && a > most / b ? most : a * b;
  }

  VtkScanner scanner_;
  PolygonMesh mesh_;
  VtkCellAdder adder_;
  VtkCells cells_;  // of a grid, until their types are read
  bool grid_ = false;
  bool types_read_ = false;
};

}  // namespace

PolygonMesh read_vtk(const std::filesystem::path& path) {
  const std::string file = read_bytes(path);
  if (!lower_case(file.substr(0, 14)).starts_with("# vtk datafile")) {
    not_of_format(path, file, "a legacy VTK file", "it does not start with '# vtk DataFile'");
  }
  return LegacyReader(file, path).read();
}

}  // namespace isobench
