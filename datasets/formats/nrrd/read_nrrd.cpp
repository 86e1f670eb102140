// NRRD. The header is read here, because the reader of VTK 9.1 ignores the space directions and carries on if data are
// missing. The tests compare samples with VTK's.
#include "isobench/datasets/formats/nrrd/read_nrrd.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>

#include "isobench/datasets/formats/reading/header_values.h"
#include "isobench/datasets/formats/reading/read_samples.h"
#include "isobench/datasets/formats/reading/sample_data.h"
#include "isobench/foundation/error.h"
#include "isobench/foundation/text.h"

namespace isobench {

namespace {

struct NrrdHeader {
  std::filesystem::path path;
  std::map<std::string, std::string> fields;

  bool has(const std::string& key) const { return fields.contains(key); }
  std::string text(const std::string& key) const { return has(key) ? fields.at(key) : std::string(); }
  std::vector<double> numbers(const std::string& key, std::size_t count) const {
    return numbers_in(text(key), count, path, key);
  }
  double number(const std::string& key, double otherwise) const {
    return has(key) ? numbers(key, 1).front() : otherwise;
  }
};

NrrdHeader read_nrrd_header(ByteReader& reader) {
  NrrdHeader header{reader.path(), {}};
  std::string line;
  if (!reader.read_line(line, 64) || !line.starts_with("NRRD000")) {
    throw DataError(header.path.string() + ": not an NRRD file; give it the ending of its own format");
  }
  while (reader.read_line(line)) {
    if (line.empty()) break;
    const std::size_t colon = line.find(": ");
    if (line[0] == '#' || colon == std::string::npos) continue;  // a comment, or a key:=value pair
    std::string key = lower_case(trimmed(line.substr(0, colon)));
    // A field's name may be written with or without blanks, in either case.
    key.erase(std::remove(key.begin(), key.end(), ' '), key.end());
    header.fields[key] = trimmed(line.substr(colon + 1));
  }
  for (const char* key : {"dimension", "sizes", "type", "encoding"}) {
    if (!header.has(key)) {
      throw DataError(fmt::format("{}: its header has no '{}'; copy or export it again", header.path.string(), key));
    }
  }
  return header;
}

/// The world's axes. Coordinates in LAS, a mirror image of RAS, become RAS when `flip` multiplies them.
std::string space_of(const NrrdHeader& header, Eigen::Vector3d& flip) {
  const std::string space = lower_case(header.text("space"));
  flip.setOnes();
  if (space == "right-anterior-superior" || space == "ras") return "RAS";
  if (space == "left-posterior-superior" || space == "lps") return "LPS";
  if (space == "left-anterior-superior" || space == "las") {
    flip.x() = -1.0;
    return "RAS";
  }
  return "";
}

/// "mm" from `"mm" "mm" "mm"`. Throws DataError unless all axes have the same unit.
std::string unit_of(const NrrdHeader& header) {
  const std::string units = header.text("spaceunits");
  std::string unit;
  for (std::size_t open = units.find('"'); open != std::string::npos; open = units.find('"', open)) {
    const std::size_t close = units.find('"', open + 1);
    if (close == std::string::npos) break;
    const std::string next = units.substr(open + 1, close - open - 1);
    if (!unit.empty() && next != unit) {
      throw DataError(
          fmt::format("{}: its axes have different units, {}; export it in mm", header.path.string(), units));
    }
    unit = next;
    open = close + 1;
  }
  return unit;
}

Lattice lattice_of(const NrrdHeader& header) {
  if (header.number("dimension", 0.0) != 3.0) {
    throw DataError(header.path.string() + ": not a 3-D scalar volume; give one of dimension 3");
  }
  const std::vector<double> sizes = header.numbers("sizes", 3);
  std::array<long long, 3> size{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    size[axis] = sizes[axis] >= 1.0 && sizes[axis] < 1e9 ? std::llround(sizes[axis]) : 0;

  Eigen::Vector3d flip;
  const std::string space = space_of(header, flip);
  const double unit = unit_in_mm(unit_of(header), header.path);
  Eigen::Matrix3d direction = Eigen::Matrix3d::Identity();
  Eigen::Vector3d spacing = Eigen::Vector3d::Ones();
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  if (header.has("spacedirections")) {
    const std::vector<double> steps = header.numbers("spacedirections", 9);
    direction = unit * (flip.asDiagonal() * Eigen::Map<const Eigen::Matrix3d>(steps.data()));
    spacing = direction.colwise().norm();
  } else if (header.has("spacings")) {
    const std::vector<double> given = header.numbers("spacings", 3);
    for (int axis = 0; axis < 3; ++axis) {
      const double length = given[static_cast<std::size_t>(axis)];
      spacing[axis] = std::isnan(length) ? 1.0 : std::abs(length);  // NaN is the format's "unknown"
    }
  }
  if (header.has("spaceorigin")) {
    const std::vector<double> given = header.numbers("spaceorigin", 3);
    origin = unit * (flip.asDiagonal() * Eigen::Map<const Eigen::Vector3d>(given.data()));
  }
  return make_lattice(header.path, size, spacing, direction, origin, space);
}

void skip_lines(ByteReader& reader, double lines) {
  std::string line;
  for (double n = 0; n < lines; ++n) {
    if (!reader.read_line(line)) return;
  }
}

void read_data(const NrrdHeader& header, const std::filesystem::path& data, std::uintmax_t begin, Volume& volume) {
  const std::string encoding = lower_case(header.text("encoding"));
  const std::string type_name = header.text("type");
  const auto type = sample_type(type_name);
  if (!type) {
    throw DataError(
        fmt::format("{}: samples of type '{}' cannot be read; export it as float", header.path.string(), type_name));
  }
  const std::size_t nodes = volume.lattice.nodes();
  const bool zipped = encoding == "gzip" || encoding == "gz";
  const bool text = encoding == "ascii" || encoding == "text" || encoding == "txt";
  if (!zipped && !text && encoding != "raw") {
    throw DataError(fmt::format("{}: its encoding '{}' cannot be read; export it with raw, gzip or ascii",
                                header.path.string(), encoding));
  }
  const ByteOrder native = std::endian::native == std::endian::big ? ByteOrder::big : ByteOrder::little;
  const std::string endian = lower_case(header.text("endian"));
  const ByteOrder order = endian == "big" ? ByteOrder::big : endian == "little" ? ByteOrder::little : native;
  const double skip = header.number("byteskip", 0.0);
  if (skip < 0.0 && !zipped) {  // -1: the data are the last bytes of the file
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(data, error);
    begin = error ? 0 : size - std::min<std::uintmax_t>(size, nodes * bytes_of(*type));
  }
  ByteReader reader(data, zipped ? Encoding::deflated : Encoding::plain, begin);
  skip_lines(reader, header.number("lineskip", 0.0));
  if (skip > 0.0) reader.skip(static_cast<std::uintmax_t>(std::min(std::ceil(skip), 1e15)));
  volume.samples = Samples(*type);
  if (text) return read_text_samples(reader, nodes, volume.samples);
  read_samples(reader, nodes, order, volume.samples);
}

}  // namespace

VolumeFile read_nrrd(const std::filesystem::path& path, const VolumeChoice& /*choice*/) {
  ByteReader reader(path, Encoding::plain);
  const NrrdHeader header = read_nrrd_header(reader);
  Volume volume;
  volume.lattice = lattice_of(header);
  if (!header.has("datafile")) {
    read_data(header, path, reader.consumed(), volume);
    return {std::move(volume), {}};
  }
  const std::string file = header.text("datafile");
  if (file.starts_with("LIST") || file.find('%') != std::string::npos) {
    throw DataError(path.string() + ": its data are spread over several files; export it as one file");
  }
  read_data(header, path.parent_path() / file, 0, volume);
  return {std::move(volume), {}};
}

}  // namespace isobench
