// NIfTI and ANALYZE. The header is binary, with fields at fixed places. It is checked here in full: the reader of VTK
// 9.1 does not check it, and leaves the orientation out of its image.
#include "isobench/datasets/formats/nifti/read_nifti.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "isobench/datasets/formats/nifti/nifti_header.h"
#include "isobench/datasets/formats/nifti/nifti_placement.h"
#include "isobench/datasets/formats/nifti/nifti_samples.h"
#include "isobench/datasets/formats/reading/read_samples.h"
#include "isobench/foundation/error.h"
#include "isobench/foundation/text.h"

namespace isobench {

namespace {

/// A name of which ".hdr", ".img" or one of both with ".gz" is the end.
struct PairName {
  std::string stem;
  std::string ending;       // without ".gz"
  std::string compression;  // ".gz", or empty

  bool is(const char* which) const { return lower_case(ending) == which; }
};

PairName pair_name(const std::filesystem::path& path) {
  std::string rest = path.string();
  std::string compression;
  if (lower_case(rest).ends_with(".gz")) {
    compression = rest.substr(rest.size() - 3);
    rest.resize(rest.size() - 3);
  }
  const std::string ending = rest.size() < 4 ? "" : rest.substr(rest.size() - 4);
  return {rest.substr(0, rest.size() - ending.size()), ending, compression};
}

/// What the other file of a pair may be called, the likeliest name first: it may be compressed or not, and in small or
/// in capital letters.
std::vector<std::filesystem::path> partners_of(const std::filesystem::path& path, const std::string& ending) {
  const PairName name = pair_name(path);
  std::vector<std::string> endings = {ending, ending == ".hdr" ? ".HDR" : ".IMG"};
  if (name.ending != lower_case(name.ending)) std::swap(endings[0], endings[1]);
  std::vector<std::filesystem::path> partners;
  for (const std::string& one : endings) {
    for (const std::string& compression : {name.compression, std::string(name.compression.empty() ? ".gz" : "")})
      partners.emplace_back(fmt::format("{}{}{}", name.stem, one, compression));
  }
  return partners;
}

std::optional<std::filesystem::path> first_that_exists(const std::vector<std::filesystem::path>& paths) {
  for (const std::filesystem::path& path : paths) {
    std::error_code error;
    if (std::filesystem::is_regular_file(path, error)) return path;
  }
  return std::nullopt;
}

/// The file that has the header. A single file of NIfTI may have the ending .img, too.
std::filesystem::path header_of(const std::filesystem::path& path) {
  if (!pair_name(path).is(".img")) return path;
  const std::vector<std::filesystem::path> headers = partners_of(path, ".hdr");
  if (auto header = first_that_exists(headers)) return *std::move(header);
  try {
    ByteReader reader(path, encoding_of(path));
    std::vector<std::string> notes;
    if (read_nifti_header(reader, false, notes).kind == NiftiKind::one_file) return path;
  } catch (const DataError&) {  // not a header
  }
  throw DataError(
      fmt::format("{}: its header, {}, is missing; put it beside it", path.string(), headers.front().string()));
}

/// The file that has the samples of a header in two files.
std::filesystem::path samples_of(const std::filesystem::path& path, const std::filesystem::path& header) {
  if (path != header) return path;
  if (!pair_name(path).is(".hdr")) {
    throw DataError(path.string() + ": its samples are in another file; give it the ending .hdr, and the other .img");
  }
  const std::vector<std::filesystem::path> images = partners_of(path, ".img");
  if (auto image = first_that_exists(images)) return *std::move(image);
  throw DataError(
      fmt::format("{}: its samples, {}, are missing; put them beside it", path.string(), images.front().string()));
}

/// The byte at which the samples begin, in a file that has other things at its beginning up to `least`.
std::uintmax_t offset_of(const NiftiFields& fields, std::size_t least, const std::filesystem::path& path,
                         std::vector<std::string>& notes) {
  constexpr double limit = 1 << 26;
  const bool is_too_small = fields.offset < static_cast<double>(least);
  if (!(fields.offset < limit) || (is_too_small && least == 0)) {
    throw DataError(
        fmt::format("{}: its samples cannot begin at byte {}, as its header states; copy or export it again",
                    path.string(), fields.offset));
  }
  if (!is_too_small) return static_cast<std::uintmax_t>(fields.offset);
  if (fields.offset != 0.0) {  // many programs write 0
    notes.push_back(
        fmt::format("{}: its header states samples from byte {}, where the header still is; they are taken "
                    "from byte {}",
                    path.string(), fields.offset, least));
  }
  return least;
}

}  // namespace

VolumeFile read_nifti(const std::filesystem::path& path, const VolumeChoice& choice) {
  VolumeFile file;
  const std::filesystem::path header = header_of(path);
  ByteReader header_reader(header, encoding_of(header));
  const NiftiFields fields = read_nifti_header(header_reader, pair_name(header).is(".hdr"), file.notes);
  const bool is_one_file = fields.kind == NiftiKind::one_file;
  file.volume.lattice = nifti_lattice(fields, header, file.notes);
  const std::vector<FileAxis> axes = nifti_axes(fields, choice, header);
  file.volume.samples = Samples(nifti_sample_type(fields, header, file.notes));
  const std::filesystem::path samples = is_one_file ? header : samples_of(path, header);
  // In one file, four bytes follow the header and say whether extensions do.
  const std::uintmax_t offset = offset_of(fields, is_one_file ? fields.bytes + 4 : 0, header, file.notes);
  ByteReader reader(samples, encoding_of(samples));
  reader.skip(offset);
  read_samples(reader, axes, fields.order, file.volume.samples);
  file.volume.samples = nifti_scaled(std::move(file.volume.samples), fields, header, file.notes);
  return file;
}

}  // namespace isobench
