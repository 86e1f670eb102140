#include "isobench/datasets/formats/write_volume.h"

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <fstream>

#include "isobench/foundation/error.h"

namespace isobench {

namespace {

static_assert(std::endian::native == std::endian::little, "samples are written in memory order");

std::string vector(const Eigen::Vector3d& v) { return fmt::format("({},{},{})", v.x(), v.y(), v.z()); }

/// What the two formats call a type.
struct TypeNames {
  const char* nrrd;
  const char* vti;
};

TypeNames names_of(SampleType type) {
  switch (type) {
    case SampleType::u8:
      return {"uint8", "UInt8"};
    case SampleType::i8:
      return {"int8", "Int8"};
    case SampleType::u16:
      return {"uint16", "UInt16"};
    case SampleType::i16:
      return {"int16", "Int16"};
    case SampleType::u32:
      return {"uint32", "UInt32"};
    case SampleType::i32:
      return {"int32", "Int32"};
    case SampleType::f32:
      return {"float", "Float32"};
    case SampleType::f64:
      return {"double", "Float64"};
    case SampleType::i64:
      return {"int64", "Int64"};
    case SampleType::u64:
      break;
  }
  return {"uint64", "UInt64"};
}

std::string nrrd_header(const Lattice& lattice, SampleType type) {
  std::string space = "space dimension: 3";
  if (lattice.space == "RAS") space = "space: right-anterior-superior";
  if (lattice.space == "LPS") space = "space: left-posterior-superior";
  const Eigen::Matrix3d steps = lattice.direction * lattice.spacing.asDiagonal();
  return fmt::format(
      "NRRD0004\ntype: {}\ndimension: 3\n{}\nsizes: {} {} {}\nspace directions: {} {} {}\n"
      "centerings: node node node\nkinds: domain domain domain\nendian: little\nencoding: raw\n"
      "space units: \"mm\" \"mm\" \"mm\"\nspace origin: {}\n\n",
      names_of(type).nrrd, space, lattice.size[0], lattice.size[1], lattice.size[2], vector(steps.col(0)),
      vector(steps.col(1)), vector(steps.col(2)), vector(lattice.origin));
}

std::string vti_head(const Lattice& lattice, SampleType type) {
  std::string cosines;  // row by row
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) cosines += fmt::format(" {}", lattice.direction(row, column));
  }
  const std::string extent =
      fmt::format("0 {} 0 {} 0 {}", lattice.size[0] - 1, lattice.size[1] - 1, lattice.size[2] - 1);
  const Eigen::Vector3d& s = lattice.spacing;
  const Eigen::Vector3d& o = lattice.origin;
  return fmt::format(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
      "<ImageData WholeExtent=\"{0}\" Origin=\"{1} {2} {3}\" Spacing=\"{4} {5} {6}\" Direction=\"{7}\">\n"
      "<Piece Extent=\"{0}\">\n<PointData Scalars=\"F\">\n"
      "<DataArray type=\"{8}\" Name=\"F\" format=\"appended\" offset=\"0\"/>\n</PointData>\n</Piece>\n"
      "</ImageData>\n<AppendedData encoding=\"raw\">\n_",
      extent, o.x(), o.y(), o.z(), s.x(), s.y(), s.z(), cosines.substr(1), names_of(type).vti);
}

}  // namespace

void write_volume(const Volume& volume, const std::filesystem::path& path) {
  const std::string ending = path.extension().string();
  if (ending != ".nrrd" && ending != ".vti") {
    throw UsageError(path.string() +
                     ": its ending is not .nrrd or .vti; volumes are written to these formats, so change the ending");
  }
  std::ofstream file(path, std::ios::binary);
  const SampleType type = volume.samples.type();
  const auto bytes = static_cast<std::uint64_t>(volume.samples.size() * bytes_of(type));
  if (ending == ".nrrd") {
    file << nrrd_header(volume.lattice, type);
  } else {
    file << vti_head(volume.lattice, type);
    file.write(reinterpret_cast<const char*>(&bytes), sizeof bytes);
  }
  volume.samples.visit([&](const auto& samples) {
    file.write(reinterpret_cast<const char*>(samples.data()), static_cast<std::streamsize>(bytes));
  });
  if (ending == ".vti") file << "\n</AppendedData>\n</VTKFile>\n";
  file.close();
  if (!file) throw Error(path.string() + ": cannot be written; check that its folder exists, is writable and has room");
}

}  // namespace isobench
