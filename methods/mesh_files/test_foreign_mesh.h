// Files of other programs, for tests: what is to be read from them, or why they are refused.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstring>
#include <string>
#include <vector>

#include "isobench/foundation/error.h"
#include "isobench/foundation/monitor.h"
#include "isobench/foundation/testing/test_folder.h"
#include "isobench/methods/mesh_files/mesh_files.h"

namespace isobench::foreign {

/// Two shapes that every format can hold: an octahedron with corners at 3 mm, 36 mm³, and a cube of 2 mm with six
/// quadrilaterals.
inline const std::string octahedron_points = "3 0 0\n-3 0 0\n0 3 0\n0 -3 0\n0 0 3\n0 0 -3\n";
inline constexpr int octahedron_faces[8][3] = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                               {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
inline constexpr double octahedron_volume = 36.0;
inline const std::string cube_points = "0 0 0\n2 0 0\n2 2 0\n0 2 0\n0 0 2\n2 0 2\n2 2 2\n0 2 2\n";
inline constexpr int cube_faces[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                         {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
inline constexpr double cube_volume = 8.0;

/// The faces as text, a line each: `before`, the corners with `first` added and `behind` after each, and `after`.
template <std::size_t faces, std::size_t corners>
std::string face_lines(const int (&all)[faces][corners], const std::string& before, int first = 0,
                       const std::string& behind = "", const std::string& after = "") {
  std::string text;
  for (const auto& face : all) {
    text += before;
    for (const int corner : face) text.append(" ").append(std::to_string(corner + first)).append(behind);
    text += after + '\n';
  }
  return text;
}

/// `text` with `from` replaced by `to`, everywhere.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
  return text;
}

/// Each line between `before` and `after`.
inline std::string each_line(const std::string& lines, const std::string& before, const std::string& after) {
  std::string text;
  for (std::size_t at = 0; at < lines.size();) {
    const std::size_t end = lines.find('\n', at);
    text.append(before).append(lines, at, end - at).append(after).append("\n");
    at = end + 1;
  }
  return text;
}

/// Line n of several.
inline std::string line_of(const std::string& lines, int n) {
  std::size_t begin = 0;
  for (; n > 0; --n) begin = lines.find('\n', begin) + 1;
  return lines.substr(begin, lines.find('\n', begin) - begin);
}

/// Numbers in binary, in either byte order.
template <typename Number>
std::string binary(std::initializer_list<Number> numbers, std::endian order) {
  std::string bytes;
  for (const Number number : numbers) {
    std::string one(sizeof(Number), '\0');
    std::memcpy(one.data(), &number, sizeof(Number));
    if (order != std::endian::native) std::reverse(one.begin(), one.end());
    bytes += one;
  }
  return bytes;
}

struct Read {
  std::size_t vertices;
  std::size_t triangles;
  double volume;      ///< mm³, signed
  std::string notes;  ///< a part of the notes, which are joined by " | "; "" if there must be none
};

struct Case {
  std::string name;
  std::string bytes;
  Read expected{};
  std::string refusal{};  ///< a part of the message, for a file that is refused
};

inline double signed_volume(const TriangleMesh& mesh) {
  double six = 0.0;
  for (const Triangle& t : mesh.triangles) {
    six += mesh.vertices[t[0]].dot(mesh.vertices[t[1]].cross(mesh.vertices[t[2]]));
  }
  return six / 6.0;
}

inline void expect_refused(const Case& one, const std::filesystem::path& path) {
  std::string message = "no error";
  try {
    read_mesh(path);
  } catch (const DataError& error) {
    message = error.what();
  } catch (const UsageError& error) {
    message = error.what();
  }
  EXPECT_TRUE(message.starts_with(path.string() + ":")) << one.name << ": " << message;
  EXPECT_NE(message.find(one.refusal), std::string::npos) << one.name << ": " << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << one.name << ": " << message;
}

inline void expect_read(const Case& one, const std::filesystem::path& path) {
  Monitor monitor;
  const TriangleMesh mesh = read_mesh(path, monitor);
  EXPECT_EQ(mesh.vertices.size(), one.expected.vertices) << one.name;
  EXPECT_EQ(mesh.triangles.size(), one.expected.triangles) << one.name;
  EXPECT_NEAR(signed_volume(mesh), one.expected.volume, 1e-12) << one.name;
  std::string notes;
  for (const std::string& note : monitor.notes()) notes += (notes.empty() ? "" : " | ") + note;
  EXPECT_EQ(notes.empty(), one.expected.notes.empty()) << one.name << ": " << notes;
  EXPECT_NE(notes.find(one.expected.notes), std::string::npos) << one.name << ": " << notes;
}

inline void expect_all(const std::vector<Case>& cases) {
  const TestFolder folder;
  for (const Case& one : cases) {
    const std::filesystem::path path = folder.write(one.name, one.bytes);
    try {
      one.refusal.empty() ? expect_read(one, path) : expect_refused(one, path);
    } catch (const Error& error) {
      ADD_FAILURE() << one.name << ": " << error.what();
    }
  }
}

}  // namespace isobench::foreign
