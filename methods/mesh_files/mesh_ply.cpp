#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "isobench/foundation/files/whole_files.h"
#include "isobench/methods/mesh_files/mesh_bytes.h"
#include "isobench/methods/mesh_files/mesh_formats.h"
#include "isobench/methods/mesh_files/mesh_text.h"

namespace isobench {

namespace {

enum class PlyType { i8, u8, i16, u16, i32, u32, f32, f64 };

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::f32;
  std::optional<PlyType> count_type;  ///< the type of a list's length; none for a property that is not a list
};

struct PlyElement {
  std::string name;
  long count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  std::string format;
  std::vector<PlyElement> elements;
};

/// Reads the values of a PLY file's body in their order, from text or binary.
class PlyBody {
 public:
  PlyBody(std::string_view bytes, const std::string& format, std::filesystem::path path)
      : bytes_(bytes),
        path_(std::move(path)),
        text_(format == "ascii"),
        order_(format == "binary_big_endian" ? std::endian::big : std::endian::little) {}

  double next(PlyType type) {
    if (text_) return next_word();
    static constexpr std::array<std::size_t, 8> kSizes{1, 1, 2, 2, 4, 4, 4, 8};
    if (bytes_.size() < kSizes[static_cast<std::size_t>(type)]) truncated();
    switch (type) {
      case PlyType::i8:
        return take_number<std::int8_t>(bytes_);
      case PlyType::u8:
        return take_number<std::uint8_t>(bytes_);
      case PlyType::i16:
        return take_number<std::int16_t>(bytes_, order_);
      case PlyType::u16:
        return take_number<std::uint16_t>(bytes_, order_);
      case PlyType::i32:
        return take_number<std::int32_t>(bytes_, order_);
      case PlyType::u32:
        return take_number<std::uint32_t>(bytes_, order_);
      case PlyType::f32:
        return take_number<float>(bytes_, order_);
      case PlyType::f64:
        break;
    }
    return take_number<double>(bytes_, order_);
  }

 private:
  double next_word() {
    constexpr std::string_view kBlanks = " \t\r\n";
    bytes_.remove_prefix(std::min(bytes_.find_first_not_of(kBlanks), bytes_.size()));
    const std::string_view word = bytes_.substr(0, bytes_.find_first_of(kBlanks));
    if (word.empty()) truncated();
    bytes_.remove_prefix(word.size());
    const std::optional<double> number = to_number(word);
    if (!number) bad_mesh(path_, fmt::format("'{}' is not a number", word));
    return *number;
  }
  [[noreturn]] void truncated() const { bad_mesh(path_, "is truncated: it has less data than its header says"); }

  std::string_view bytes_;
  std::filesystem::path path_;
  bool text_;
  std::endian order_;
};

PlyType to_type(const TextLines& lines, std::size_t word) {
  static constexpr std::array<std::pair<std::string_view, PlyType>, 16> kNames{{{"char", PlyType::i8},
                                                                                {"uchar", PlyType::u8},
                                                                                {"short", PlyType::i16},
                                                                                {"ushort", PlyType::u16},
                                                                                {"int", PlyType::i32},
                                                                                {"uint", PlyType::u32},
                                                                                {"float", PlyType::f32},
                                                                                {"double", PlyType::f64},
                                                                                {"int8", PlyType::i8},
                                                                                {"uint8", PlyType::u8},
                                                                                {"int16", PlyType::i16},
                                                                                {"uint16", PlyType::u16},
                                                                                {"int32", PlyType::i32},
                                                                                {"uint32", PlyType::u32},
                                                                                {"float32", PlyType::f32},
                                                                                {"float64", PlyType::f64}}};
  if (word >= lines.words().size()) lines.fail("a type is missing in the header");
  for (const auto& [name, type] : kNames) {
    if (name == lines.words()[word]) return type;
  }
  lines.fail(fmt::format("'{}' is not a PLY type", lines.words()[word]));
}

PlyProperty read_property(const TextLines& lines) {
  const std::vector<std::string_view>& words = lines.words();
  PlyProperty property;
  const bool list = words.size() > 1 && words[1] == "list";
  if (words.size() != (list ? 5U : 3U)) lines.fail("a property line has too few or too many words");
  if (list) property.count_type = to_type(lines, 2);
  property.type = to_type(lines, list ? 3 : 1);
  property.name = words.back();
  return property;
}

/// Leaves `bytes` at the body.
PlyHeader read_header(std::string_view& bytes, const std::filesystem::path& path) {
  PlyHeader header;
  TextLines lines(bytes, path);
  lines.next();  // "ply"
  bool complete = false;
  while (!complete && lines.next()) {
    const std::vector<std::string_view>& words = lines.words();
    if (words[0] == "format" && words.size() == 3) {
      header.format = words[1];
    } else if (words[0] == "element" && words.size() == 3) {
      header.elements.push_back({std::string(words[1]), lines.integer(2), {}});
      if (header.elements.back().count < 0) lines.fail("counts cannot be negative");
    } else if (words[0] == "property" && !header.elements.empty()) {
      header.elements.back().properties.push_back(read_property(lines));
    } else if (words[0] != "comment" && words[0] != "obj_info" && words[0] != "end_header") {
      lines.fail(fmt::format("'{}' is not allowed here in a PLY header", words[0]));
    }
    complete = words[0] == "end_header";
  }
  if (!complete) bad_mesh(path, "is truncated: it ends within its header");
  bytes = lines.rest();
  if (header.format != "ascii" && header.format != "binary_little_endian" && header.format != "binary_big_endian") {
    bad_mesh(path, fmt::format("'{}' is not a PLY format", header.format));
  }
  return header;
}

/// The number of values of a property: 1, or a list's length.
double length_of(const PlyProperty& property, PlyBody& body, const std::filesystem::path& path) {
  if (!property.count_type) return 1.0;
  const double count = body.next(*property.count_type);
  if (!(count >= 0.0) || count != std::floor(count)) {
    bad_mesh(path, fmt::format("a list of '{}' has {} values; copy or export it again", property.name, count));
  }
  return count;
}

void skip(const PlyProperty& property, PlyBody& body, const std::filesystem::path& path) {
  const double count = length_of(property, body, path);
  for (double n = 0; n < count; ++n) body.next(property.type);
}

void skip(const PlyElement& element, PlyBody& body, const std::filesystem::path& path) {
  // An element without properties takes no bytes: do not loop over a huge count of them.
  for (long n = 0; n < element.count && !element.properties.empty(); ++n) {
    for (const PlyProperty& property : element.properties) skip(property, body, path);
  }
}

void read_vertices(const PlyElement& element, PlyBody& body, const std::filesystem::path& path, PolygonMesh& mesh) {
  constexpr std::array<std::string_view, 3> kAxes{"x", "y", "z"};
  if (!mesh.vertices.empty()) bad_mesh(path, "has vertices twice; export it again");
  std::array<int, 3> found{};
  std::vector<int> axes;  // of each property; −1 if it is no coordinate
  for (const PlyProperty& property : element.properties) {
    const auto at = std::find(kAxes.begin(), kAxes.end(), property.count_type ? "" : property.name);
    axes.push_back(at == kAxes.end() ? -1 : static_cast<int>(at - kAxes.begin()));
    if (axes.back() >= 0) ++found[static_cast<std::size_t>(axes.back())];
  }
  if (found != std::array<int, 3>{1, 1, 1}) bad_mesh(path, "its vertices do not have the properties x, y and z");
  for (long v = 0; v < element.count; ++v) {
    Eigen::Vector3d& vertex = mesh.vertices.emplace_back();
    for (std::size_t p = 0; p < axes.size(); ++p) {
      if (axes[p] >= 0) {
        vertex[axes[p]] = body.next(element.properties[p].type);
      } else {
        skip(element.properties[p], body, path);
      }
    }
  }
}

/// Faces or strips: the corners of each of them go to `add`.
template <typename Add>
void read_lists(const PlyElement& element, PlyBody& body, const std::filesystem::path& path, Add add) {
  const auto is_corners = [](const PlyProperty& property) {
    return property.count_type && (property.name == "vertex_indices" || property.name == "vertex_index");
  };
  const auto found = std::count_if(element.properties.begin(), element.properties.end(), is_corners);
  if (found != 1 && element.count > 0) {
    bad_mesh(path, fmt::format("its element '{}' does not have one list vertex_indices", element.name));
  }
  std::vector<double> corners;
  for (long n = 0; n < element.count; ++n) {
    for (const PlyProperty& property : element.properties) {
      if (!is_corners(property)) {
        skip(property, body, path);
        continue;
      }
      corners.clear();
      const double count = length_of(property, body, path);
      for (double c = 0; c < count; ++c) corners.push_back(body.next(property.type));
      add(corners);
    }
  }
}

void read_faces(const PlyElement& element, PlyBody& body, const std::filesystem::path& path, PolygonMesh& mesh) {
  std::size_t points = 0, edges = 0;
  read_lists(element, body, path, [&](const std::vector<double>& corners) {
    if (corners.size() < 3) {
      ++(corners.size() == 1 ? points : edges);
      return;
    }
    for (const double corner : corners) mesh.corners.push_back(to_index(corner));
    mesh.end_polygon();
  });
  mesh.note_left_out(points, edges);
}

/// In a list of strips, −1 ends a strip.
void read_strips(const PlyElement& element, PlyBody& body, const std::filesystem::path& path, PolygonMesh& mesh) {
  std::vector<std::uint32_t> strip;
  std::size_t triangles = 0;
  read_lists(element, body, path, [&](const std::vector<double>& corners) {
    strip.clear();
    for (const double corner : corners) {
      if (corner != -1.0) {
        strip.push_back(to_index(corner));
        continue;
      }
      triangles += mesh.add_strip(strip);
      strip.clear();
    }
    triangles += mesh.add_strip(strip);
  });
  if (triangles > 0) mesh.notes.push_back(fmt::format("its strips of triangles were cut into {} triangles", triangles));
}

}  // namespace

PolygonMesh read_ply(const std::filesystem::path& path) {
  const std::string file = read_bytes(path);
  std::string_view bytes = file;
  if (bytes.starts_with(utf8_mark)) bytes.remove_prefix(utf8_mark.size());
  if (!bytes.starts_with("ply") || bytes.substr(3, 1).find_first_of(" \t\r\n") != 0) {
    not_of_format(path, bytes, "a PLY file", "it does not start with the word ply");
  }
  const PlyHeader header = read_header(bytes, path);
  PlyBody body(bytes, header.format, path);
  PolygonMesh mesh;
  for (const PlyElement& element : header.elements) {
    if (element.name == "vertex") {
      read_vertices(element, body, path, mesh);
    } else if (element.name == "face") {
      read_faces(element, body, path, mesh);
    } else if (element.name == "tristrips") {
      read_strips(element, body, path, mesh);
    } else {
      skip(element, body, path);
    }
  }
  return mesh;
}

void write_ply(const TriangleMesh& mesh, const std::filesystem::path& path) {
  std::string bytes = fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment lengths in mm\n{}element vertex {}\nproperty double x\n"
      "property double y\nproperty double z\nelement face {}\nproperty list uchar uint vertex_indices\nend_header\n",
      mesh.space.empty() ? "" : "comment " + space_mark(mesh) + "\n", mesh.vertices.size(), mesh.triangles.size());
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    for (int axis = 0; axis < 3; ++axis) put_number(bytes, vertex[axis]);
  }
  for (const Triangle& triangle : mesh.triangles) {
    put_number(bytes, std::uint8_t{3});
    for (const std::uint32_t corner : triangle) put_number(bytes, corner);
  }
  write_text(path, bytes);
}

}  // namespace isobench
