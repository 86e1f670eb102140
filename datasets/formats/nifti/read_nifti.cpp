// NIfTI-1 and NIfTI-2, header and samples in one file. The header is binary, with fields at fixed places. It is checked
// here in full: the reader of VTK 9.1 does not check it, and leaves the orientation out of its image.
#include "isobench/datasets/formats/nifti/read_nifti.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <fstream>

#include "isobench/datasets/formats/reading/header_values.h"
#include "isobench/datasets/formats/reading/read_samples.h"
#include "isobench/datasets/formats/reading/sample_data.h"
#include "isobench/foundation/error.h"

namespace isobench {

namespace {

constexpr std::size_t size_1 = 348;  // of a header of version 1
constexpr std::size_t size_2 = 540;

/// The fields of both versions in one form.
struct NiftiHeader {
  int version = 1;
  ByteOrder order = ByteOrder::little;
  std::array<long long, 8> dim{};  // [0] is the number of dimensions
  int datatype = 0;
  int bits = 0;
  std::array<double, 8> pixdim{};  // [0] is the qform's handedness
  double offset = 0.0;
  double slope = 0.0;
  double intercept = 0.0;
  int units = 0;
  int qform = 0;
  int sform = 0;
  Eigen::Vector3d quaternion = Eigen::Vector3d::Zero();
  Eigen::Vector3d qoffset = Eigen::Vector3d::Zero();
  Eigen::Matrix<double, 3, 4> srow = Eigen::Matrix<double, 3, 4>::Zero();
};

template <class Value>
Value value_at(const std::string& bytes, std::size_t at, ByteOrder order) {
  std::array<char, sizeof(Value)> raw{};
  std::memcpy(raw.data(), bytes.data() + at, raw.size());
  if ((order == ByteOrder::big) != (std::endian::native == std::endian::big)) std::reverse(raw.begin(), raw.end());
  return std::bit_cast<Value>(raw);
}

/// Consecutive fields of one type. The versions differ in the types and in the order of the groups.
template <class Value, class Target>
void fields_at(const std::string& bytes, std::size_t at, ByteOrder order, Target* target, std::size_t count) {
  for (std::size_t n = 0; n < count; ++n)
    target[n] = static_cast<Target>(value_at<Value>(bytes, at + n * sizeof(Value), order));
}

template <class Real>
void read_places(const std::string& bytes, std::size_t quaternion, std::size_t qoffset, std::size_t srow,
                 NiftiHeader& header) {
  fields_at<Real>(bytes, quaternion, header.order, header.quaternion.data(), 3);
  fields_at<Real>(bytes, qoffset, header.order, header.qoffset.data(), 3);
  Eigen::Matrix<double, 4, 3> rows;
  fields_at<Real>(bytes, srow, header.order, rows.data(), 12);
  header.srow = rows.transpose();
}

NiftiHeader version_1(const std::string& bytes, ByteOrder order) {
  NiftiHeader header;
  header.order = order;
  fields_at<std::int16_t>(bytes, 40, order, header.dim.data(), 8);
  header.datatype = value_at<std::int16_t>(bytes, 70, order);
  header.bits = value_at<std::int16_t>(bytes, 72, order);
  fields_at<float>(bytes, 76, order, header.pixdim.data(), 8);
  header.offset = value_at<float>(bytes, 108, order);
  header.slope = value_at<float>(bytes, 112, order);
  header.intercept = value_at<float>(bytes, 116, order);
  header.units = static_cast<unsigned char>(bytes[123]);
  header.qform = value_at<std::int16_t>(bytes, 252, order);
  header.sform = value_at<std::int16_t>(bytes, 254, order);
  read_places<float>(bytes, 256, 268, 280, header);
  return header;
}

NiftiHeader version_2(const std::string& bytes, ByteOrder order) {
  NiftiHeader header;
  header.version = 2;
  header.order = order;
  header.datatype = value_at<std::int16_t>(bytes, 12, order);
  header.bits = value_at<std::int16_t>(bytes, 14, order);
  fields_at<std::int64_t>(bytes, 16, order, header.dim.data(), 8);
  fields_at<double>(bytes, 104, order, header.pixdim.data(), 8);
  header.offset = static_cast<double>(value_at<std::int64_t>(bytes, 168, order));
  header.slope = value_at<double>(bytes, 176, order);
  header.intercept = value_at<double>(bytes, 184, order);
  header.qform = value_at<std::int32_t>(bytes, 344, order);
  header.sform = value_at<std::int32_t>(bytes, 348, order);
  read_places<double>(bytes, 352, 376, 400, header);
  header.units = value_at<std::int32_t>(bytes, 500, order);
  return header;
}

NiftiHeader read_nifti_header(ByteReader& reader) {
  std::string bytes(size_2, '\0');
  const std::string path = reader.path().string();
  if (reader.read(bytes.data(), size_1) == size_1) {
    for (const ByteOrder order : {ByteOrder::little, ByteOrder::big}) {
      const auto size = static_cast<std::size_t>(value_at<std::uint32_t>(bytes, 0, order));
      if (size == size_1 && bytes.compare(344, 4, std::string("n+1\0", 4)) == 0) return version_1(bytes, order);
      if (size == size_1 && bytes.compare(344, 4, std::string("ni1\0", 4)) == 0) {
        throw DataError(path + ": its samples are in another file; convert header and samples to one .nii file");
      }
      if (size == size_2 && bytes.compare(4, 4, std::string("n+2\0", 4)) == 0) {
        if (reader.read(bytes.data() + size_1, size_2 - size_1) == size_2 - size_1) return version_2(bytes, order);
        throw DataError(path + ": truncated in its header; copy or export it again");
      }
    }
  }
  throw DataError(path + ": not a NIfTI file; give it the ending of its own format");
}

SampleType type_of(const NiftiHeader& header, const std::filesystem::path& path) {
  static constexpr std::pair<int, SampleType> types[] = {
      {2, SampleType::u8},     {4, SampleType::i16},   {8, SampleType::i32},   {16, SampleType::f32},
      {64, SampleType::f64},   {256, SampleType::i8},  {512, SampleType::u16}, {768, SampleType::u32},
      {1024, SampleType::i64}, {1280, SampleType::u64}};
  for (const auto& [code, type] : types) {
    if (code != header.datatype) continue;
    if (static_cast<std::size_t>(header.bits) == 8 * bytes_of(type)) return type;
    throw DataError(
        fmt::format("{}: its samples have {} bits, which does not fit its datatype {}; copy or export it again",
                    path.string(), header.bits, code));
  }
  throw DataError(fmt::format("{}: samples of datatype {} cannot be read; convert it to a volume of integers or floats",
                              path.string(), header.datatype));
}

std::array<long long, 3> size_of(const NiftiHeader& header, const std::filesystem::path& path) {
  if (header.dim[0] < 1 || header.dim[0] > 7) {
    throw DataError(fmt::format("{}: its header states {} dimensions, not 1 to 7; copy or export it again",
                                path.string(), header.dim[0]));
  }
  const auto dimensions = static_cast<std::size_t>(header.dim[0]);
  for (std::size_t axis = 4; axis <= dimensions; ++axis) {
    if (header.dim[axis] > 1)
      throw DataError(path.string() + ": it has more than three dimensions; give one 3-D volume");
  }
  std::array<long long, 3> size{1, 1, 1};
  for (std::size_t axis = 1; axis <= std::min<std::size_t>(dimensions, 3); ++axis) size[axis - 1] = header.dim[axis];
  return size;
}

double unit_of(const NiftiHeader& header) {
  switch (header.units & 7) {
    case 1:
      return 1000.0;
    case 3:
      return 1e-3;
    default:
      return 1.0;
  }
}

/// The columns are the steps from node to node, in the header's unit.
Eigen::Matrix3d steps_of(const NiftiHeader& header) {
  Eigen::Vector3d voxel(header.pixdim[1], header.pixdim[2], header.pixdim[3]);
  voxel = voxel.cwiseAbs();
  if (header.sform > 0) return header.srow.leftCols<3>();
  if (header.qform <= 0) return voxel.asDiagonal();
  // A unit quaternion with real part ≥ 0; the real part is not stored. Rounding may make the stored part longer than 1.
  const double rest = 1.0 - header.quaternion.squaredNorm();
  Eigen::Quaterniond q(std::sqrt(std::max(rest, 0.0)), header.quaternion[0], header.quaternion[1],
                       header.quaternion[2]);
  if (header.pixdim[0] < 0.0) voxel[2] = -voxel[2];
  return q.normalized().toRotationMatrix() * voxel.asDiagonal();
}

Lattice lattice_of(const NiftiHeader& header, const std::filesystem::path& path) {
  const bool placed = header.sform > 0 || header.qform > 0;
  const Eigen::Matrix3d steps = unit_of(header) * steps_of(header);
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  if (placed) origin = unit_of(header) * (header.sform > 0 ? Eigen::Vector3d(header.srow.col(3)) : header.qoffset);
  return make_lattice(path, size_of(header, path), steps.colwise().norm(), steps, origin, placed ? "RAS" : "");
}

/// Skips what is left of the header and the extensions that may follow it.
void skip_to_samples(ByteReader& reader, const NiftiHeader& header) {
  constexpr double limit = 1 << 26;
  if (!(header.offset < limit)) {
    throw DataError(
        fmt::format("{}: its samples cannot begin at byte {}, as its header states; copy or export it again",
                    reader.path().string(), header.offset));
  }
  const std::size_t done = header.version == 1 ? size_1 : size_2;
  const std::size_t offset = std::max(static_cast<std::size_t>(std::max(header.offset, 0.0)), done + 4);
  reader.skip(offset - done);
}

/// slope · sample + intercept, computed in double. Integers keep their type where this changes nothing, so that labels
/// stay what they are.
Samples scaled(Samples samples, const NiftiHeader& header) {
  // The format states that a slope of 0 means no scaling.
  if (!std::isfinite(header.slope) || header.slope == 0.0) return samples;
  return samples.visit([&](auto& values) -> Samples {
    using T = SampleOf<decltype(values)>;
    if (std::is_integral_v<T> && header.slope == 1.0 && header.intercept == 0.0) return std::move(values);
    using Real = RealOf<T>;
    if constexpr (std::is_same_v<T, Real>) {
      for (Real& value : values) value = static_cast<Real>(header.slope * value + header.intercept);
      return std::move(values);
    } else {
      std::vector<Real> reals;
      reals.reserve(values.size());
      for (const T value : values)
        reals.push_back(static_cast<Real>(header.slope * static_cast<double>(value) + header.intercept));
      return reals;
    }
  });
}

bool is_gzip(const std::filesystem::path& path) {
  char magic[2] = {};
  std::ifstream(path, std::ios::binary).read(magic, sizeof magic);
  return magic[0] == '\x1f' && magic[1] == '\x8b';
}

}  // namespace

VolumeFile read_nifti(const std::filesystem::path& path, const VolumeChoice& /*choice*/) {
  ByteReader reader(path, is_gzip(path) ? Encoding::deflated : Encoding::plain);
  const NiftiHeader header = read_nifti_header(reader);
  Volume volume;
  volume.lattice = lattice_of(header, path);
  volume.samples = Samples(type_of(header, path));
  skip_to_samples(reader, header);
  read_samples(reader, volume.lattice.nodes(), header.order, volume.samples);
  volume.samples = scaled(std::move(volume.samples), header);
  return {std::move(volume), {}};
}

}  // namespace isobench
