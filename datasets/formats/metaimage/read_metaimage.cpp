// MetaImage. The header is read here, because the reader of VTK 9.1 ignores TransformMatrix, prints to the terminal and
// carries on if data are missing. The tests compare samples with VTK's.
#include "isobench/datasets/formats/metaimage/read_metaimage.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "isobench/datasets/formats/metaimage/metaimage_header.h"
#include "isobench/datasets/formats/metaimage/metaimage_lattice.h"
#include "isobench/datasets/formats/reading/read_data_files.h"
#include "isobench/datasets/formats/reading/sample_data.h"
#include "isobench/foundation/error.h"
#include "isobench/foundation/text.h"

namespace isobench {

namespace {

/// MET_UCHAR_ARRAY says no more than MET_UCHAR with several channels. The format gives a MET_LONG four bytes, whatever
/// a machine's long has.
SampleType type_of(const MetaImageHeader& header) {
  const std::string stated = header.text({"ElementType"}, "");
  std::string name;
  for (const char c : stated) name.push_back(c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c);
  const std::string array = "_ARRAY";
  if (name.ends_with(array)) name.resize(name.size() - array.size());
  if (name == "MET_LONG") return SampleType::i32;
  if (name == "MET_ULONG") return SampleType::u32;
  const auto type = name.starts_with("MET_") ? sample_type(name) : std::nullopt;
  if (type) return *type;
  throw DataError(fmt::format("{}: its ElementType '{}' cannot be read; export it as a scalar type such as MET_FLOAT",
                              header.path.string(), stated.substr(0, 60)));
}

DataLayout layout_of(MetaImageHeader& header) {
  constexpr double most_skipped = 1e15;
  DataLayout layout;
  layout.is_text = !header.flag({"BinaryData"}, true);
  layout.order =
      header.flag({"BinaryDataByteOrderMSB", "ElementByteOrderMSB"}, false) ? ByteOrder::big : ByteOrder::little;
  if (header.flag({"CompressedData"}, false)) layout.encoding = Encoding::deflated;
  const double skip = header.numbers({"HeaderSize"}, 1, {0.0}).front();
  if (!(skip >= -1.0 && skip <= most_skipped && skip == std::floor(skip))) {
    throw DataError(fmt::format("{}: its HeaderSize '{}' is neither -1 nor a number of bytes; correct its header",
                                header.path.string(), header.text({"HeaderSize"}, "").substr(0, 60)));
  }
  if (skip < 0.0 && layout.is_text)
    throw DataError(header.path.string() + ": a HeaderSize of -1 is not possible for text; correct its header");
  layout.is_at_end = skip < 0.0;
  layout.packed = static_cast<std::uintmax_t>(std::max(skip, 0.0));
  layout.begin_is_stated = header.has("HeaderSize");
  layout.at_begin = "HeaderSize = 0";
  layout.at_end = "HeaderSize = -1";
  return layout;
}

/// `axes` may begin with components, which are in every file, and which DimSize does not count.
VolumeData files_of(const MetaImageHeader& header, std::uintmax_t attached, const std::vector<ArrayAxis>& axes) {
  const std::string names = header.text({"ElementDataFile"}, "");
  if (lower_case(names) == "local") return {header.path, true, {{header.path, attached}}, axes.size()};
  const std::size_t components = axes.front().kind == AxisKind::component ? 1 : 0;
  std::vector<long long> sizes;
  for (const ArrayAxis& axis : axes) sizes.push_back(axis.size);
  const auto parts_of = [&](std::size_t files, long long dimension) {
    const FileParts parts{files, static_cast<std::size_t>(dimension) + components};
    check_parts(parts, sizes, header.path);
    return parts.axes;
  };
  const auto slowest = static_cast<long long>(axes.size() - components - 1);
  if (!header.list.empty()) {
    std::string text = names;
    if (text.ends_with("D") || text.ends_with("d")) text.pop_back();  // LIST 2D
    const std::vector<long long> numbers = numbers_at_end(text, 1).numbers;
    const std::size_t each = parts_of(header.list.size(), numbers.empty() ? slowest : numbers.front());
    return {header.path, false, files_of_list(header.list, header.path), each};
  }
  if (names.find('%') == std::string::npos)
    return {header.path, false, {{data_file_beside(header.path, names)}}, axes.size()};
  const TextAndNumbers pattern = numbers_at_end(names, 3);
  const std::vector<long long>& numbers = pattern.numbers;
  const FilePattern files =
      file_pattern(pattern.text, !numbers.empty() ? numbers[0] : 1, numbers.size() > 1 ? numbers[1] : axes.back().size,
                   numbers.size() > 2 ? numbers[2] : 1, header.path);
  const std::size_t each = parts_of(files.count(), slowest);
  return {header.path, false, files_of_pattern(files, header.path), each};
}

}  // namespace

VolumeFile read_metaimage(const std::filesystem::path& path, const VolumeChoice& choice) {
  ByteReader reader(path, Encoding::plain);
  MetaImageHeader header = read_metaimage_header(reader);
  VolumeFile file;
  file.volume.lattice = metaimage_lattice(header);
  const std::vector<ArrayAxis> axes = metaimage_axes(header);
  const std::vector<FileAxis> places = choose_places(axes, choice, path);
  const DataLayout layout = layout_of(header);
  file.volume.samples = Samples(type_of(header));
  read_data_files(files_of(header, reader.consumed(), axes), places, layout, file.volume.samples, header.notes);
  file.notes = std::move(header.notes);
  return file;
}

}  // namespace isobench
