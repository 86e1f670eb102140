// MGH and MGZ, the volumes of FreeSurfer: a header of 284 bytes, always big-endian, the samples, and records about how
// the image was taken, which are not needed here. Format:
// https://surfer.nmr.mgh.harvard.edu/fswiki/FsTutorial/MghFormat
#include "isobench/datasets/formats/mgh/read_mgh.h"

#include <fmt/format.h>

#include <cstdint>
#include <utility>

#include "isobench/datasets/formats/reading/header_values.h"
#include "isobench/datasets/formats/reading/read_samples.h"
#include "isobench/foundation/error.h"

namespace isobench {

namespace {

constexpr std::size_t mgh_header_bytes = 284;

struct MghHeader {
  std::array<long long, 3> size{};
  long long frames = 0;
  int type = 0;
  Eigen::Vector3d spacing = Eigen::Vector3d::Ones();
  // What FreeSurfer takes where a file does not state it: coronal slices, from left to right, from top to bottom.
  Eigen::Matrix3d direction{{-1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, {0.0, -1.0, 0.0}};
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
};

template <class Value>
Value mgh_value(const std::string& bytes, std::size_t at) {
  return number_at<Value>(bytes.data() + at, ByteOrder::big);
}

/// Three numbers in single precision.
Eigen::Vector3d mgh_vector(const std::string& bytes, std::size_t at) {
  return {mgh_value<float>(bytes, at), mgh_value<float>(bytes, at + 4), mgh_value<float>(bytes, at + 8)};
}

MghHeader read_mgh_header(ByteReader& reader, std::vector<std::string>& notes) {
  const std::string path = reader.path().string();
  std::string bytes(mgh_header_bytes, '\0');
  const bool is_whole = reader.read(bytes.data(), bytes.size()) == bytes.size();
  // The version is 1. Later programs keep there, too, what the image is meant for, in the next byte.
  const auto version = mgh_value<std::uint32_t>(bytes, 0);
  if (version > 0xffff || (version & 0xff) != 1) {
    throw DataError(path + ": not a volume of FreeSurfer; give it the ending of its own format");
  }
  if (!is_whole) throw DataError(path + ": truncated in its header; copy or export it again");
  MghHeader header;
  for (std::size_t axis = 0; axis < 3; ++axis) header.size[axis] = mgh_value<std::int32_t>(bytes, 4 + 4 * axis);
  header.frames = mgh_value<std::int32_t>(bytes, 16);
  header.type = mgh_value<std::int32_t>(bytes, 20);
  if (mgh_value<std::int16_t>(bytes, 28) <= 0) {
    notes.push_back(
        path +
        ": it does not state where it lies; coronal slices of 1 mm about the origin are taken, as FreeSurfer "
        "does");
    return header;
  }
  header.spacing = mgh_vector(bytes, 30);
  for (int axis = 0; axis < 3; ++axis)
    header.direction.col(axis) = mgh_vector(bytes, 42 + 12 * static_cast<std::size_t>(axis));
  header.centre = mgh_vector(bytes, 78);
  return header;
}

SampleType type_of(const MghHeader& header, const std::filesystem::path& path) {
  static constexpr std::pair<int, SampleType> types[] = {
      {0, SampleType::u8}, {1, SampleType::i32}, {3, SampleType::f32}, {4, SampleType::i16}, {10, SampleType::u16}};
  for (const auto& [code, type] : types) {
    if (code == header.type) return type;
  }
  throw DataError(fmt::format("{}: samples of type {} cannot be read; convert it with: mri_convert -odt float",
                              path.string(), header.type));
}

Lattice lattice_of(const MghHeader& header, const std::filesystem::path& path) {
  Lattice lattice = make_lattice(path, header.size, header.spacing, header.direction, header.centre, "RAS");
  // The centre lies half the size from the first node: between two nodes where the size is odd.
  Eigen::Vector3d half;
  for (int axis = 0; axis < 3; ++axis) half[axis] = 0.5 * lattice.size[static_cast<std::size_t>(axis)];
  lattice.origin = header.centre - lattice.direction * lattice.spacing.cwiseProduct(half);
  return lattice;
}

}  // namespace

VolumeFile read_mgh(const std::filesystem::path& path, const VolumeChoice& choice) {
  VolumeFile file;
  ByteReader reader(path, encoding_of(path));
  const MghHeader header = read_mgh_header(reader, file.notes);
  file.volume.lattice = lattice_of(header, path);
  file.volume.samples = Samples(type_of(header, path));
  const long long frames = size_in(static_cast<double>(header.frames));
  if (frames == 0) {
    throw DataError(
        fmt::format("{}: its header states {} frames; copy or export it again", path.string(), header.frames));
  }
  const auto steps = static_cast<std::size_t>(frames);
  const std::size_t nodes = file.volume.lattice.nodes();
  constexpr std::size_t most_samples = std::size_t{1} << 50U;  // a petabyte
  if (nodes > most_samples / steps) {
    throw DataError(fmt::format("{}: {} frames of {} samples cannot be; the header is damaged, copy or export it again",
                                path.string(), steps, nodes));
  }
  const FileAxis axes[] = {{nodes}, {steps, place_on_axis(choice.step, steps, "step", path)}};
  read_samples(reader, axes, ByteOrder::big, file.volume.samples);
  return file;
}

}  // namespace isobench
