#include "isobench/datasets/formats/write_volume.h"

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <fstream>

#include "isobench/foundation/error.h"

namespace isobench {

namespace {

static_assert(std::endian::native == std::endian::little, "samples are written as they lie in memory");

std::string vector(const Eigen::Vector3d& v) { return fmt::format("({},{},{})", v.x(), v.y(), v.z()); }

std::string nrrd_header(const Lattice& lattice) {
  std::string space = "space dimension: 3";
  if (lattice.space == "RAS") space = "space: right-anterior-superior";
  if (lattice.space == "LPS") space = "space: left-posterior-superior";
  const Eigen::Matrix3d steps = lattice.direction * lattice.spacing.asDiagonal();
  return fmt::format(
      "NRRD0004\ntype: float\ndimension: 3\n{}\nsizes: {} {} {}\nspace directions: {} {} {}\n"
      "centerings: node node node\nkinds: domain domain domain\nendian: little\nencoding: raw\n"
      "space units: \"mm\" \"mm\" \"mm\"\nspace origin: {}\n\n",
      space, lattice.size[0], lattice.size[1], lattice.size[2], vector(steps.col(0)), vector(steps.col(1)),
      vector(steps.col(2)), vector(lattice.origin));
}

std::string vti_head(const Lattice& lattice) {
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
      "<DataArray type=\"Float32\" Name=\"F\" format=\"appended\" offset=\"0\"/>\n</PointData>\n</Piece>\n"
      "</ImageData>\n<AppendedData encoding=\"raw\">\n_",
      extent, o.x(), o.y(), o.z(), s.x(), s.y(), s.z(), cosines.substr(1));
}

}  // namespace

void write_volume(const Volume& volume, const std::filesystem::path& path) {
  const std::string ending = path.extension().string();
  if (ending != ".nrrd" && ending != ".vti") {
    throw UsageError(path.string() + ": volumes are written to files that end in .nrrd or .vti");
  }
  std::ofstream file(path, std::ios::binary);
  const auto bytes = static_cast<std::uint64_t>(volume.samples.size() * sizeof(float));
  if (ending == ".nrrd") {
    file << nrrd_header(volume.lattice);
  } else {
    file << vti_head(volume.lattice);
    file.write(reinterpret_cast<const char*>(&bytes), sizeof bytes);
  }
  file.write(reinterpret_cast<const char*>(volume.samples.data()), static_cast<std::streamsize>(bytes));
  if (ending == ".vti") file << "\n</AppendedData>\n</VTKFile>\n";
  file.close();
  if (!file) throw Error(path.string() + ": cannot be written; is its folder there, writable and not full?");
}

}  // namespace isobench
