#include "isobench/methods/external/points_file.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <map>
#include <sstream>
#include <string>

#include "isobench/datasets/formats/reading/byte_reader.h"
#include "isobench/datasets/formats/reading/header_values.h"
#include "isobench/datasets/formats/reading/sample_data.h"
#include "isobench/foundation/text.h"
#include "isobench/methods/mesh_files/mesh_formats.h"
#include "isobench/methods/mesh_files/mesh_text.h"

namespace isobench::external {

namespace {

namespace fs = std::filesystem;
using Points = std::vector<Eigen::Vector3d>;

Points read_text_points(const fs::path& path) {
  const std::string bytes = read_bytes(path);
  TextLines lines(bytes, path);
  Points points;
  while (lines.next()) points.emplace_back(lines.number(0), lines.number(1), lines.number(2));
  return points;
}

/// The header of an array of two axes.
struct ArrayHeader {
  std::map<std::string, std::string> fields;
  std::size_t row = 0;    ///< numbers per point
  std::size_t count = 0;  ///< points
};

std::size_t whole(double number, const fs::path& path) {
  if (!(number >= 1.0 && number < 1e10) || number != std::floor(number)) {
    bad_mesh(path, fmt::format("{} is neither a number of points nor a number of coordinates", number));
  }
  return static_cast<std::size_t>(number);
}

ArrayHeader read_header(ByteReader& reader) {
  const fs::path& path = reader.path();
  ArrayHeader header;
  std::string line;
  if (!reader.read_line(line, 64) || !line.starts_with("NRRD000")) bad_mesh(path, "not an NRRD file");
  while (reader.read_line(line) && !line.empty()) {
    const std::size_t colon = line.find(": ");
    if (line[0] != '#' && colon != std::string::npos) {
      header.fields[trimmed(line.substr(0, colon))] = trimmed(line.substr(colon + 1));
    }
  }
  for (const char* key : {"dimension", "sizes", "type", "encoding"}) {
    if (!header.fields.contains(key)) bad_mesh(path, fmt::format("its header has no '{}'", key));
  }
  if (header.fields["dimension"] != "2") {
    bad_mesh(path, "a set of points is an array of two axes: coordinates and points");
  }
  const std::vector<double> sizes = numbers_in(header.fields["sizes"], 2, path, "sizes");
  header.row = whole(sizes[0], path);
  header.count = whole(sizes[1], path);
  if (header.row < 3 || header.row > 64) bad_mesh(path, fmt::format("a point cannot have {} numbers", header.row));
  return header;
}

// Point by point, so that a header that lies about the number of points cannot claim memory.
Points read_rows(ByteReader& reader, const ArrayHeader& header, SampleType type, ByteOrder order) {
  const std::size_t bytes = header.row * bytes_of(type);
  Points points;
  std::vector<char> row(bytes);
  std::vector<double> numbers(header.row);
  for (std::size_t n = 0; n < header.count; ++n) {
    if (reader.read(row.data(), bytes) != bytes) {
      bad_mesh(reader.path(), fmt::format("truncated: it holds {} of {} points", n, header.count));
    }
    convert_samples(row.data(), header.row, type, order, numbers.data());
    points.emplace_back(numbers[0], numbers[1], numbers[2]);
  }
  if (reader.encoding() == Encoding::deflated) reader.finish();
  return points;
}

Points read_text_rows(ByteReader& reader, const ArrayHeader& header) {
  Points points;
  std::vector<double> row;
  std::string line;
  while (points.size() < header.count && reader.read_line(line)) {
    std::istringstream words(line);
    for (std::string word; words >> word && points.size() < header.count;) {
      const std::optional<double> number = to_number(word);
      if (!number) bad_mesh(reader.path(), fmt::format("expected a number, found '{}'", word));
      row.push_back(*number);
      if (row.size() < header.row) continue;
      points.emplace_back(row[0], row[1], row[2]);
      row.clear();
    }
  }
  if (points.size() < header.count) {
    bad_mesh(reader.path(), fmt::format("truncated: it holds {} of {} points", points.size(), header.count));
  }
  return points;
}

Points read_nrrd_points(const fs::path& path) {
  ByteReader reader(path, Encoding::plain);
  ArrayHeader header = read_header(reader);
  const std::string encoding = header.fields["encoding"];
  const std::optional<SampleType> type = sample_type(header.fields["type"]);
  if (!type) bad_mesh(path, fmt::format("numbers of type '{}' cannot be read", header.fields["type"]));
  const bool apart = header.fields.contains("data file") || header.fields.contains("datafile");
  const fs::path data =
      apart ? path.parent_path() / header.fields[header.fields.contains("data file") ? "data file" : "datafile"] : path;
  const std::uintmax_t begin = apart ? 0 : reader.consumed();
  const bool zipped = encoding == "gzip" || encoding == "gz";
  ByteReader body(data, zipped ? Encoding::deflated : Encoding::plain, begin);
  if (encoding == "ascii" || encoding == "text" || encoding == "txt") return read_text_rows(body, header);
  if (encoding != "raw" && !zipped) {
    bad_mesh(path, fmt::format("its encoding '{}' cannot be read; readable are raw, gzip and ascii", encoding));
  }
  return read_rows(body, header, *type, header.fields["endian"] == "big" ? ByteOrder::big : ByteOrder::little);
}

}  // namespace

Points read_points(const fs::path& path) {
  const std::string ending = lower_case(path.extension().string());
  Points points;
  if (ending == ".nrrd" || ending == ".nhdr") points = read_nrrd_points(path);
  if (ending == ".xyz" || ending == ".txt") points = read_text_points(path);
  if (ending == ".ply") points = read_ply(path).vertices;
  if (ending == ".off") points = read_off(path).vertices;
  if (ending == ".obj") points = read_obj(path).vertices;
  if (ending == ".vtp") points = read_vtp(path).vertices;
  if (points.empty()) bad_mesh(path, "holds no points");
  for (std::size_t n = 0; n < points.size(); ++n) {
    if (!points[n].allFinite()) bad_mesh(path, fmt::format("the coordinates of point {} are not finite", n));
  }
  return points;
}

}  // namespace isobench::external
