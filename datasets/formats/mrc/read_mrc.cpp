#include "isobench/datasets/formats/mrc/read_mrc.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "isobench/datasets/formats/mrc/mrc_header.h"
#include "isobench/datasets/formats/mrc/mrc_placement.h"
#include "isobench/datasets/formats/reading/read_samples.h"
#include "isobench/foundation/error.h"

namespace isobench {

namespace {

constexpr int half_floats = 12;

[[noreturn]] void refuse_samples(const std::filesystem::path& path, const std::string& what) {
  throw DataError(
      fmt::format("{}: its samples are {}, which cannot be read; convert it to mode 1, 2 or 6", path.string(), what));
}

/// Bytes are signed since 2014. Before that, most programs meant them unsigned, and IMOD says which.
SampleType type_of_bytes(const MrcHeader& header, const std::filesystem::path& path, std::vector<std::string>& notes) {
  constexpr int are_signed = 1;
  constexpr int are_pairs = 16;
  if ((header.imod_flags & are_pairs) != 0) refuse_samples(path, "of 4 bits");
  if (header.is_imod) {
    if ((header.imod_flags & are_signed) != 0) return SampleType::i8;
    notes.push_back(path.string() + ": its samples are unsigned bytes, as the mark of IMOD in its header says");
    return SampleType::u8;
  }
  if (header.least >= 0.0 && header.largest > 127.0 && header.largest <= 255.0) {
    notes.push_back(fmt::format("{}: its samples are unsigned bytes, because its header states that they go up to {}",
                                path.string(), header.largest));
    return SampleType::u8;
  }
  return SampleType::i8;
}

SampleType mrc_sample_type(const MrcHeader& header, const std::filesystem::path& path,
                           std::vector<std::string>& notes) {
  switch (header.mode) {
    case 0:
      return type_of_bytes(header, path, notes);
    case 1:
      return SampleType::i16;
    case 2:
      return SampleType::f32;
    case 6:
    case half_floats:
      return SampleType::u16;
    case 3:
    case 4:
      refuse_samples(path, "complex numbers");
    case 16:
      refuse_samples(path, "colours");
    case 101:
      refuse_samples(path, "of 4 bits");
    default:
      refuse_samples(path, fmt::format("of mode {}", header.mode));
  }
}

/// How many volumes the sections make up.
std::size_t volumes_of(const MrcHeader& header, const std::filesystem::path& path, std::vector<std::string>& notes) {
  const long long sections = header.size[2];
  const long long each = header.intervals[2];
  const bool along_z = header.axis[2] == 2;
  constexpr int first_of_stacks = 401;
  if (header.space_group >= first_of_stacks && header.space_group <= first_of_stacks + 229 && along_z && each > 0) {
    if (sections % each == 0) return static_cast<std::size_t>(sections / each);
    throw DataError(fmt::format("{}: it states volumes of {} sections each, but {} sections in all; correct its header",
                                path.string(), each, sections));
  }
  if (header.space_group == 0 && along_z && each == 1 && sections > 1) {
    notes.push_back(path.string() + ": its header states a stack of images; they are taken as the slices of a volume");
  }
  return 1;
}

std::vector<float> floats_of_halves(const std::vector<std::uint16_t>& halves) {
  std::vector<float> floats(halves.size());
  std::transform(halves.begin(), halves.end(), floats.begin(), [](std::uint16_t half) {
    return static_cast<float>(Eigen::half(Eigen::half_impl::raw_uint16_to_half(half)));
  });
  return floats;
}

/// Nothing in an old file tells whether its bytes are signed: says what was taken if that matters.
void note_doubtful_bytes(const MrcHeader& header, const Samples& samples, const std::filesystem::path& path,
                         std::vector<std::string>& notes) {
  if (samples.type() != SampleType::i8 || header.is_imod || header.version / 10 == 2014 || header.least < 0.0) return;
  const auto& values = samples.as<std::int8_t>();
  if (std::none_of(values.begin(), values.end(), [](std::int8_t value) { return value < 0; })) return;
  notes.push_back(
      path.string() +
      ": its bytes are taken as signed, as the format demands since 2014; older programs mean them unsigned");
}

}  // namespace

VolumeFile read_mrc(const std::filesystem::path& path, const VolumeChoice& choice) {
  VolumeFile file;
  ByteReader reader(path, encoding_of(path));
  const MrcHeader header = read_mrc_header(reader, file.notes);
  const std::size_t volumes = volumes_of(header, path, file.notes);
  const long long sections = header.size[2] / static_cast<long long>(volumes);
  file.volume.lattice = mrc_lattice(header, sections, path, file.notes);
  Samples samples(mrc_sample_type(header, path, file.notes));
  const FileAxis axes[] = {{file.volume.lattice.nodes()}, {volumes, place_on_axis(choice.step, volumes, "step", path)}};
  reader.skip(static_cast<std::uintmax_t>(header.extension_bytes));
  read_samples(reader, axes, header.order, samples);
  note_doubtful_bytes(header, samples, path, file.notes);
  if (header.mode == half_floats) samples = floats_of_halves(samples.as<std::uint16_t>());
  file.volume.samples = std::move(samples);
  return file;
}

}  // namespace isobench
