// For tests: one small volume with a spacing that is not 1, an oblique direction and an origin, written by hand in
// every format, and what must be read from it.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "isobench/datasets/formats/read_volume.h"
#include "isobench/foundation/error.h"
#include "isobench/foundation/testing/test_files.h"

namespace isobench {

inline constexpr int nx = 7;
inline constexpr int ny = 6;
inline constexpr int nz = 5;
inline const Eigen::Vector3d spacing(0.5, 1.25, 3.0);
inline const Eigen::Vector3d origin(-12.5, 40.0, 7.25);

/// Turned about an axis that is none of the lattice's: all nine cosines differ from 0 and 1.
inline Eigen::Matrix3d oblique() {
  return Eigen::AngleAxisd(0.6, Eigen::Vector3d(1.0, 2.0, 3.0).normalized()).toRotationMatrix();
}

/// A bump that no reflection or exchange of axes maps to itself, in whole numbers 0..255 that every sample type can
/// hold; its level set at `closed_isovalue` lies within the volume.
inline float sample_at(int i, int j, int k) {
  const int bump = 120 - 9 * (i - 3) * (i - 3) - 20 * (j - 2) * (j - 2) - 24 * (k - 2) * (k - 2);
  return static_cast<float>(std::max(0, bump) + i + 2 * j + 3 * k);
}
inline constexpr double closed_isovalue = 80.0;

inline std::vector<float> samples() {
  std::vector<float> values;
  for (int k = 0; k < nz; ++k) {
    for (int j = 0; j < ny; ++j) {
      for (int i = 0; i < nx; ++i) values.push_back(sample_at(i, j, k));
    }
  }
  return values;
}

inline Eigen::Vector3d world_of(int i, int j, int k) {
  return origin + oblique() * spacing.cwiseProduct(Eigen::Vector3d(i, j, k));
}

/// The samples as floats, for tests that do not look at their type.
inline std::vector<float> floats_of(const Volume& volume) { return as_float(volume).samples; }

/// Each node's sample and world position. 1e-5 mm: NIfTI keeps its orientation in single precision.
inline void expect_oblique(const Volume& volume) {
  ASSERT_EQ(volume.lattice.size, (std::array<int, 3>{nx, ny, nz}));
  ASSERT_EQ(volume.samples.size(), static_cast<std::size_t>(nx * ny * nz));
  const FloatVolume floats = as_float(volume);
  for (int k = 0; k < nz; ++k) {
    for (int j = 0; j < ny; ++j) {
      for (int i = 0; i < nx; ++i) {
        EXPECT_EQ(floats.at(i, j, k), sample_at(i, j, k));
        const Eigen::Vector3d world =
            volume.lattice.to_world(volume.lattice.spacing.cwiseProduct(Eigen::Vector3d(i, j, k)));
        EXPECT_LT((world - world_of(i, j, k)).norm(), 1e-5) << i << ' ' << j << ' ' << k;
      }
    }
  }
  EXPECT_LT((volume.lattice.spacing - spacing).norm(), 1e-5);
}

inline Volume volume_of(const std::filesystem::path& path, const VolumeChoice& choice = {}) {
  return read_volume(path, choice).volume;
}

/// Expects a message that has `part`, names the file, and is one sentence without a line break.
inline void expect_data_error(const std::filesystem::path& path, const std::string& part,
                              const VolumeChoice& choice = {}) {
  try {
    read_volume(path, choice);
    ADD_FAILURE() << path << " was read; expected: " << part;
  } catch (const DataError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find(part), std::string::npos) << message;
    EXPECT_NE(message.find(path.filename().string()), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

inline std::string nrrd_header(const std::string& type, const std::string& encoding) {
  const Eigen::Matrix3d steps = oblique() * spacing.asDiagonal();
  std::string directions;
  for (int axis = 0; axis < 3; ++axis) {
    directions += fmt::format(" ({:.17g},{:.17g},{:.17g})", steps(0, axis), steps(1, axis), steps(2, axis));
  }
  return fmt::format(
      "NRRD0004\n# a comment\ntype: {}\ndimension: 3\nspace: left-posterior-superior\nsizes: {} {} {}\n"
      "space directions:{}\nspace origin: ({},{},{})\nendian: little\nencoding: {}\nkey:=value\n",
      type, nx, ny, nz, directions, origin[0], origin[1], origin[2], encoding);
}

inline std::string metaimage_header(const std::string& more) {
  std::string matrix;
  for (int axis = 0; axis < 3; ++axis) {
    for (int row = 0; row < 3; ++row) matrix += fmt::format(" {:.17g}", oblique()(row, axis));
  }
  return fmt::format(
      "ObjectType = Image\nNDims = 3\nBinaryData = True\nDimSize = {} {} {}\nElementSpacing = {} {} {}\nOffset = {} {} "
      "{}\n"
      "TransformMatrix ={}\n{}\n",
      nx, ny, nz, spacing[0], spacing[1], spacing[2], origin[0], origin[1], origin[2], matrix, more);
}

/// A NIfTI-1 header of 348 bytes and its four bytes of extension, field by field as the format states them.
class NiftiHeader {
 public:
  explicit NiftiHeader(bool swapped = false) : bytes_(352, '\0'), swapped_(swapped) {
    put<std::int32_t>(0, 348);
    put<std::int16_t>(40, 3);
    const int sizes[] = {nx, ny, nz, 1, 1, 1, 1};
    for (int n = 0; n < 7; ++n)
      put<std::int16_t>(42 + 2 * static_cast<std::size_t>(n), static_cast<std::int16_t>(sizes[n]));
    put<std::int16_t>(70, 16);  // float
    put<std::int16_t>(72, 32);
    put<float>(76, 1.0F);  // qfac
    for (int n = 0; n < 3; ++n) put<float>(80 + 4 * static_cast<std::size_t>(n), static_cast<float>(spacing[n]));
    put<float>(108, 352.0F);
    bytes_[123] = 2;  // mm
    std::memcpy(bytes_.data() + 344, "n+1", 4);
  }
  template <class Value>
  void put(std::size_t at, Value value) {
    bytes_.replace(at, sizeof(Value), bytes_of_value(value, swapped_));
  }
  void put_sform(const Eigen::Matrix3d& direction, const Eigen::Vector3d& first) {
    put<std::int16_t>(254, 1);
    const Eigen::Matrix3d steps = direction * spacing.asDiagonal();
    for (int row = 0; row < 3; ++row) {
      const std::size_t at = 280 + 16 * static_cast<std::size_t>(row);
      for (int column = 0; column < 3; ++column)
        put<float>(at + 4 * static_cast<std::size_t>(column), static_cast<float>(steps(row, column)));
      put<float>(at + 12, static_cast<float>(first[row]));
    }
  }
  void put_qform(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& first) {
    put<std::int16_t>(252, 1);
    const Eigen::Quaterniond q(rotation);
    const double sign = q.w() < 0.0 ? -1.0 : 1.0;  // the format stores b, c, d and takes a ≥ 0
    const Eigen::Vector3d bcd = sign * q.vec();
    for (int n = 0; n < 3; ++n) {
      put<float>(256 + 4 * static_cast<std::size_t>(n), static_cast<float>(bcd[n]));
      put<float>(268 + 4 * static_cast<std::size_t>(n), static_cast<float>(first[n]));
    }
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
  bool swapped_;
};

inline std::string vti_text(const std::string& values) {
  std::string direction;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) direction += fmt::format("{:.17g} ", oblique()(row, column));
  }
  // The extent starts at (2, 0, 0), so the image's own origin lies two steps before the first node.
  const Eigen::Vector3d image_origin = origin - oblique() * Eigen::Vector3d(2.0 * spacing[0], 0.0, 0.0);
  const std::string extent = fmt::format("2 {} 0 {} 0 {}", nx + 1, ny - 1, nz - 1);
  return fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
      "<ImageData WholeExtent=\"{0}\" Origin=\"{1:.17g} {2:.17g} {3:.17g}\" Spacing=\"{4} {5} {6}\" "
      "Direction=\"{7}\">\n"
      "<Piece Extent=\"{0}\"><PointData Scalars=\"v\"><DataArray type=\"Float32\" Name=\"v\" "
      "format=\"ascii\">{8}</DataArray>"
      "</PointData></Piece></ImageData></VTKFile>\n",
      extent, image_origin[0], image_origin[1], image_origin[2], spacing[0], spacing[1], spacing[2], direction, values);
}

inline std::string text_of_samples() {
  std::string text;
  for (const float value : samples()) text += fmt::format("{} ", value);
  return text;
}

inline std::string inrimage(const std::string& fields, const std::string& data) {
  std::string header = "#INRIMAGE-4#{\n" + fields;
  header.resize(256 - 4, '\n');
  return header + "##}\n" + data;
}

inline std::string inrimage_fields(const std::string& type, const std::string& cpu) {
  return fmt::format("XDIM={}\nYDIM={}\nZDIM={}\nVDIM=1\n{}\nCPU={}\nVX={}\nVY={}\nVZ={}\n", nx, ny, nz, type, cpu,
                     spacing[0], spacing[1], spacing[2]);
}

}  // namespace isobench
