#include "isobench/datasets/formats/reading/read_data_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "isobench/foundation/error.h"

namespace isobench {

namespace {

std::size_t samples_on(std::span<const FileAxis> axes) {
  std::size_t samples = 1;
  for (const FileAxis& axis : axes) samples *= axis.size;
  return samples;
}

std::size_t kept_on(std::span<const FileAxis> axes) {
  std::size_t kept = 1;
  for (const FileAxis& axis : axes) kept *= axis.chosen ? 1 : axis.size;
  return kept;
}

/// The axes of the array in file `n`; none if nothing in it is kept.
std::vector<FileAxis> axes_in_file(std::span<const FileAxis> axes, std::size_t axes_in_each, std::size_t files,
                                   std::size_t n) {
  std::vector<FileAxis> part(axes.begin(), axes.begin() + static_cast<std::ptrdiff_t>(axes_in_each));
  if (axes_in_each == axes.size()) {
    FileAxis& last = part.back();
    last.size /= files;
    if (!last.chosen) return part;
    if (*last.chosen / last.size != n) return {};
    last.chosen = *last.chosen % last.size;
    return part;
  }
  for (const FileAxis& axis : axes.subspan(axes_in_each)) {
    if (axis.chosen && *axis.chosen != n % axis.size) return {};
    n /= axis.size;
  }
  return part;
}

std::uintmax_t offset_after_lines(const DataFile& file, std::uintmax_t lines) {
  if (lines == 0) return file.offset;
  ByteReader reader(file.path, Encoding::plain, file.offset);
  std::uintmax_t offset = file.offset;
  std::vector<char> block(std::size_t{1} << 16U);
  for (;;) {
    const std::size_t got = reader.read(block.data(), block.size());
    if (got == 0) return offset;  // the reader of the samples finds that there are none
    for (std::size_t n = 0; n < got; ++n) {
      if (block[n] == '\n' && --lines == 0) return offset + n + 1;
    }
    offset += got;
  }
}

/// How many bytes there are, unpacked. Compressed data must be read for that; what `limit` leaves out is not counted.
std::uintmax_t unpacked_bytes(const DataFile& file, Encoding encoding, std::uintmax_t limit) {
  ByteReader reader(file.path, encoding, file.offset);
  const std::uintmax_t possible = reader.possible_bytes();
  return encoding == Encoding::plain ? possible : reader.skip(std::min(limit, possible));
}

/// How many bytes lie before the last `bytes` of the unpacked data.
std::uintmax_t bytes_before(const DataFile& file, Encoding encoding, std::uintmax_t bytes) {
  constexpr std::uintmax_t longest_header = std::uintmax_t{64} << 20U;
  const std::uintmax_t limit = bytes + longest_header;
  const std::uintmax_t all = unpacked_bytes(file, encoding, limit);
  if (all < bytes) {
    throw DataError(
        fmt::format("{}: truncated: its header states {} bytes up to its end, but at most {} follow; copy or "
                    "export it again",
                    file.path.string(), bytes, all));
  }
  if (encoding != Encoding::plain && all == limit) {
    throw DataError(
        fmt::format("{}: more than {} MiB lie before its last {} bytes; state how many bytes are to be skipped",
                    file.path.string(), longest_header >> 20U, bytes));
  }
  return all - bytes;
}

class DataFilesReader {
 public:
  DataFilesReader(const VolumeData& data, const DataLayout& layout, Samples& samples, std::vector<std::string>& notes)
      : data_(data), layout_(layout), samples_(samples), notes_(notes) {}

  /// Of files that together cannot hold what the header states, nothing is read.
  void take_addresses(std::span<const FileAxis> axes) {
    if (data_.files.size() == 1) return;
    const std::uintmax_t possible = ByteReader(data_.files, layout_.encoding).possible_bytes();
    const std::uintmax_t least = layout_.is_text ? 2 : bytes_of(samples_.type());
    const std::size_t stated = samples_on(axes);
    if (possible / least + data_.files.size() < stated) {
      throw DataError(
          fmt::format("{}: truncated: it states {} samples, but its data files have at most {}; copy or "
                      "export them again",
                      data_.header.string(), stated, possible / least + data_.files.size()));
    }
    reserve_samples(samples_, kept_on(axes), layout_.encoding);
  }

  void read(const DataFile& file, std::span<const FileAxis> axes) {
    DataFile begin = file;
    begin.offset = offset_after_lines(file, layout_.lines) + layout_.packed;
    const std::uintmax_t bytes = std::uintmax_t{samples_on(axes)} * bytes_of(samples_.type());
    const std::uintmax_t skipped =
        layout_.is_at_end ? bytes_before(begin, layout_.encoding, bytes + layout_.after) : layout_.unpacked;
    ByteReader reader(begin.path, layout_.encoding, begin.offset);
    reader.skip(skipped);
    if (layout_.is_text) {
      if (read_text_samples(reader, axes, samples_)) note_rest(file, "numbers");
      return;
    }
    if (layout_.encoding == Encoding::plain && reader.possible_bytes() > bytes)
      check_surplus(file, reader.possible_bytes() - bytes);
    read_samples(reader, axes, layout_.order, samples_);
    if (layout_.encoding != Encoding::plain) check_surplus(file, reader.surplus());
  }

 private:
  void check_surplus(const DataFile& file, std::uintmax_t surplus) {
    if (surplus == 0 || layout_.is_at_end) return;
    const std::string name = file.path.filename().string();
    if (!data_.is_attached && !layout_.begin_is_stated) {
      throw DataError(fmt::format(
          "{}: its data file '{}' is {} byte{} longer than its samples, so where they begin is not known; write '{}' "
          "into the header if they are its last bytes, '{}' if they are its first",
          data_.header.string(), name, surplus, surplus == 1 ? "" : "s", layout_.at_end, layout_.at_begin));
    }
    note_rest(file, fmt::format("{} byte{}", surplus, surplus == 1 ? "" : "s"));
  }

  void note_rest(const DataFile& file, const std::string& rest) {
    if (is_noted_) return;
    is_noted_ = true;
    notes_.push_back(printable(fmt::format("{}: '{}' has {} after its samples, which were not used",
                                           data_.header.string(), file.path.filename().string(), rest)));
  }

  const VolumeData& data_;
  const DataLayout& layout_;
  Samples& samples_;
  std::vector<std::string>& notes_;
  bool is_noted_ = false;
};

}  // namespace

void read_data_files(const VolumeData& data, std::span<const FileAxis> axes, const DataLayout& layout, Samples& samples,
                     std::vector<std::string>& notes) {
  DataFilesReader reader(data, layout, samples, notes);
  reader.take_addresses(axes);
  for (std::size_t n = 0; n < data.files.size(); ++n) {
    const std::vector<FileAxis> part = axes_in_file(axes, data.axes_in_each, data.files.size(), n);
    if (!part.empty()) reader.read(data.files[n], part);
  }
}

}  // namespace isobench
