#include "isobench/datasets/formats/nrrd/nrrd_data.h"

#include <fmt/format.h>

#include <cmath>

#include "isobench/datasets/formats/reading/sample_data.h"
#include "isobench/foundation/error.h"
#include "isobench/foundation/text.h"

namespace isobench {

namespace {

constexpr double most_skipped = 1e15;

ByteOrder order_of(NrrdHeader& header, SampleType type, const DataLayout& layout) {
  const std::string endian = lower_case(header.text("endian"));
  if (endian == "big") return ByteOrder::big;
  if (endian == "little" || layout.is_text || bytes_of(type) == 1) return ByteOrder::little;
  if (!endian.empty()) {
    throw DataError(fmt::format("{}: its endian '{}' is neither little nor big; correct its header",
                                header.path.string(), endian.substr(0, 60)));
  }
  header.note("its header does not state the order of bytes (endian); little was taken");
  return ByteOrder::little;
}

double whole_skip(const NrrdHeader& header, const char* key) {
  const double skip = header.number(key, 0.0);
  if (skip == std::floor(skip) && std::abs(skip) <= most_skipped) return skip;
  throw DataError(fmt::format("{}: '{}' is '{}', not a whole number; correct its header", header.path.string(), key,
                              header.text(key).substr(0, 60)));
}

void set_encoding(const NrrdHeader& header, DataLayout& layout) {
  const std::string encoding = lower_case(header.text("encoding"));
  if (encoding == "gzip" || encoding == "gz") {
    layout.encoding = Encoding::deflated;
  } else if (encoding == "bzip2" || encoding == "bz2") {
    layout.encoding = Encoding::bzip2;
  } else if (encoding == "hex") {
    layout.encoding = Encoding::hex;
  } else if (encoding == "ascii" || encoding == "text" || encoding == "txt") {
    layout.is_text = true;
  } else if (encoding != "raw") {
    throw DataError(fmt::format("{}: its encoding '{}' is not known; export it with raw, gzip, bzip2, hex or ascii",
                                header.path.string(), encoding.substr(0, 60)));
  }
}

}  // namespace

SampleType nrrd_type(const NrrdHeader& header) {
  const std::string name = lower_case(header.text("type"));
  const auto type = sample_type(name);
  if (type) return *type;
  throw DataError(fmt::format("{}: samples of type '{}' cannot be read; export them as numbers, for example float",
                              header.path.string(), name));
}

DataLayout nrrd_layout(NrrdHeader& header, SampleType type) {
  DataLayout layout;
  set_encoding(header, layout);
  layout.order = order_of(header, type, layout);
  const double lines = whole_skip(header, "lineskip");
  if (lines < 0.0) throw DataError(header.path.string() + ": its line skip is below 0; correct its header");
  layout.lines = static_cast<std::uintmax_t>(lines);
  const double skip = whole_skip(header, "byteskip");
  const bool is_packed = layout.encoding == Encoding::deflated || layout.encoding == Encoding::bzip2;
  if (skip < 0.0) {
    // -1: the samples are the last bytes; -2: but for one, and so on.
    if (layout.is_text || layout.encoding == Encoding::hex) {
      throw DataError(fmt::format("{}: a byte skip below 0 is not possible with the encoding '{}'; correct its header",
                                  header.path.string(), header.text("encoding").substr(0, 60)));
    }
    layout.is_at_end = true;
    layout.after = static_cast<std::uintmax_t>(-1.0 - skip);
  } else {
    (is_packed ? layout.unpacked : layout.packed) = static_cast<std::uintmax_t>(skip);
  }
  layout.begin_is_stated = header.has("byteskip") || header.has("lineskip");
  layout.at_begin = "byte skip: 0";
  layout.at_end = "byte skip: -1";
  return layout;
}

VolumeData nrrd_files(const NrrdHeader& header, std::uintmax_t attached, const std::vector<ArrayAxis>& axes) {
  if (!header.has("datafile")) return {header.path, true, {{header.path, attached}}, axes.size()};
  const std::string names = header.text("datafile");
  std::vector<long long> sizes;
  for (const ArrayAxis& axis : axes) sizes.push_back(axis.size);
  const auto parts_of = [&](std::size_t files, std::optional<long long> dimension) {
    const FileParts parts{files, dimension ? static_cast<std::size_t>(*dimension) : axes.size() - 1};
    check_parts(parts, sizes, header.path);
    return parts.axes;
  };
  if (!header.list.empty()) {
    const std::vector<long long> numbers = numbers_at_end(names, 1).numbers;
    const std::size_t each =
        parts_of(header.list.size(), numbers.empty() ? std::nullopt : std::optional(numbers.front()));
    return {header.path, false, files_of_list(header.list, header.path), each};
  }
  const TextAndNumbers pattern = numbers_at_end(names, 4);
  if (names.find('%') == std::string::npos || pattern.numbers.size() < 3)
    return {header.path, false, {{data_file_beside(header.path, names)}}, axes.size()};
  const FilePattern files =
      file_pattern(pattern.text, pattern.numbers[0], pattern.numbers[1], pattern.numbers[2], header.path);
  const std::size_t each =
      parts_of(files.count(), pattern.numbers.size() == 4 ? std::optional(pattern.numbers[3]) : std::nullopt);
  return {header.path, false, files_of_pattern(files, header.path), each};
}

}  // namespace isobench
