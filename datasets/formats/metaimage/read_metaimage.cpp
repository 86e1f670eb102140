// MetaImage. The header is read here, because the reader of VTK 9.1 ignores TransformMatrix, prints to the terminal and
// carries on if data are missing. The tests compare samples with VTK's.
#include "isobench/datasets/formats/metaimage/read_metaimage.h"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "isobench/datasets/formats/reading/header_values.h"
#include "isobench/datasets/formats/reading/read_samples.h"
#include "isobench/datasets/formats/reading/sample_data.h"
#include "isobench/foundation/error.h"
#include "isobench/foundation/text.h"

namespace isobench {

namespace {

class Header {
 public:
  explicit Header(ByteReader& reader) : path_(reader.path()) {
    std::string line;
    while (reader.read_line(line)) {
      const std::size_t equals = line.find('=');
      if (equals == std::string::npos || line.find('\0') != std::string::npos) break;
      const std::string key = trimmed(line.substr(0, equals));
      fields_[key] = trimmed(line.substr(equals + 1));
      if (key == "ElementDataFile") return;  // the last field by definition; plain data may follow
    }
    if (!fields_.contains("ObjectType") && !fields_.contains("NDims")) {
      throw DataError(path_.string() + ": not a MetaImage file; give it the ending of its own format");
    }
    throw DataError(path_.string() + ": truncated: its header has no ElementDataFile; copy or export it again");
  }

  std::string text(std::initializer_list<const char*> keys, const std::string& otherwise) const {
    for (const char* key : keys) {
      if (fields_.contains(key)) return fields_.at(key);
    }
    return otherwise;
  }
  bool flag(std::initializer_list<const char*> keys, bool otherwise) const {
    const std::string value = text(keys, otherwise ? "True" : "False");
    return value == "True" || value == "true" || value == "T" || value == "1";
  }
  std::vector<double> numbers(std::initializer_list<const char*> keys, std::size_t count,
                              const std::string& otherwise) const {
    return numbers_in(text(keys, otherwise), count, path_, *keys.begin());
  }

 private:
  std::filesystem::path path_;
  std::map<std::string, std::string> fields_;
};

Lattice lattice_of(const Header& header, const std::filesystem::path& path) {
  if (header.numbers({"NDims"}, 1, "3").front() != 3.0)
    throw DataError(path.string() + ": its NDims is not 3; give a 3-D volume");
  if (header.numbers({"ElementNumberOfChannels"}, 1, "1").front() != 1.0) {
    throw DataError(path.string() + ": its samples are vectors; give a scalar volume");
  }
  const std::vector<double> dims = header.numbers({"DimSize"}, 3, "");
  std::array<long long, 3> size{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    size[axis] = dims[axis] >= 1.0 && dims[axis] < 1e9 ? std::llround(dims[axis]) : 0;
  const double unit = unit_in_mm(header.text({"DistanceUnits"}, "mm"), path);
  // ElementSize, the extent of a sample, takes the place of a missing distance between samples.
  const std::vector<double> spacing = header.numbers({"ElementSpacing", "ElementSize"}, 3, "1 1 1");
  const std::vector<double> origin = header.numbers({"Offset", "Position", "Origin"}, 3, "0 0 0");
  // The file has row after row. A row is the world direction of one axis, which is a column here.
  const std::vector<double> matrix =
      header.numbers({"TransformMatrix", "Rotation", "Orientation"}, 9, "1 0 0 0 1 0 0 0 1");
  return make_lattice(path, size, unit * Eigen::Vector3d(spacing.data()),
                      Eigen::Map<const Eigen::Matrix3d>(matrix.data()), unit * Eigen::Vector3d(origin.data()), "LPS");
}

}  // namespace

VolumeFile read_metaimage(const std::filesystem::path& path, const VolumeChoice& /*choice*/) {
  ByteReader reader(path, Encoding::plain);
  const Header header(reader);
  Volume volume;
  volume.lattice = lattice_of(header, path);
  const std::string type_name = header.text({"ElementType"}, "");
  const auto type = sample_type(type_name);
  if (!type)
    throw DataError(fmt::format("{}: its ElementType '{}' cannot be read; export it as a scalar type such as MET_FLOAT",
                                path.string(), type_name));
  const bool big = header.flag({"BinaryDataByteOrderMSB", "ElementByteOrderMSB"}, false);
  const bool compressed = header.flag({"CompressedData"}, false);
  const std::size_t nodes = volume.lattice.nodes();
  volume.samples = Samples(*type);

  const auto read = [&](ByteReader& data) {
    if (!header.flag({"BinaryData"}, true)) return read_text_samples(data, nodes, volume.samples);
    read_samples(data, nodes, big ? ByteOrder::big : ByteOrder::little, volume.samples);
  };
  const std::string file = header.text({"ElementDataFile"}, "");
  const Encoding encoding = compressed ? Encoding::deflated : Encoding::plain;
  if (file == "LOCAL" || file == "Local" || file == "local") {
    if (!compressed) {
      read(reader);
    } else {
      ByteReader data(path, encoding, reader.consumed());
      read(data);
    }
    return {std::move(volume), {}};
  }
  if (file.empty() || file == "LIST" || file.find('%') != std::string::npos) {
    throw DataError(path.string() + ": its data are spread over several files; export it as one file");
  }
  const double skip = header.numbers({"HeaderSize"}, 1, "0").front();
  const std::filesystem::path data_path = path.parent_path() / file;
  const std::uintmax_t bytes = nodes * bytes_of(*type);
  std::error_code error;
  std::uintmax_t file_bytes = std::filesystem::file_size(data_path, error);
  if (error) file_bytes = 0;  // opening the file throws the error
  // A HeaderSize of -1 means that the data are the last bytes of the file. One beyond the file's end counts as its end.
  const std::uintmax_t offset = skip >= 0.0
                                    ? static_cast<std::uintmax_t>(std::min(skip, static_cast<double>(file_bytes)))
                                    : file_bytes - std::min(bytes, file_bytes);
  ByteReader data(data_path, encoding, offset);
  read(data);
  return {std::move(volume), {}};
}

}  // namespace isobench
