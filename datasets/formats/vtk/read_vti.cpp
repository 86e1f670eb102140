// VTI: samples at the nodes of an image, in one piece or in several.
#include "isobench/datasets/formats/vtk/read_vti.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "isobench/datasets/formats/reading/header_values.h"
#include "isobench/datasets/formats/vtk/vtk_xml.h"
#include "isobench/foundation/error.h"

namespace isobench {

namespace {

/// First and last node along i, j, k.
using Extent = std::array<long long, 6>;

Extent extent_of(const std::string& text, const std::filesystem::path& path) {
  Extent extent{};
  const std::vector<double> numbers = numbers_in(text, 6, path, "extent");
  for (std::size_t n = 0; n < 6; ++n) {
    if (!(std::abs(numbers[n]) <= std::numeric_limits<int>::max()) || numbers[n] != std::floor(numbers[n])) {
      throw DataError(
          fmt::format("{}: its extent '{}' is not six whole numbers; copy or export it again", path.string(), text));
    }
    extent[n] = static_cast<long long>(numbers[n]);
  }
  return extent;
}

std::array<long long, 3> size_of(const Extent& extent) {
  return {extent[1] - extent[0] + 1, extent[3] - extent[2] + 1, extent[5] - extent[4] + 1};
}

Lattice lattice_of(const VtkElement& image, const Extent& extent, const std::filesystem::path& path) {
  const std::vector<double> spacing = numbers_in(image.attribute("Spacing", "1 1 1"), 3, path, "Spacing");
  const std::vector<double> origin = numbers_in(image.attribute("Origin", "0 0 0"), 3, path, "Origin");
  const std::vector<double> cosines =
      numbers_in(image.attribute("Direction", "1 0 0 0 1 0 0 0 1"), 9, path, "Direction");
  const Eigen::Matrix3d direction = Eigen::Map<const Eigen::Matrix3d>(cosines.data()).transpose();
  const Eigen::Vector3d steps(spacing.data());
  // The extent need not start at 0.
  const Eigen::Vector3d first = steps.cwiseProduct(
      Eigen::Vector3d(static_cast<double>(extent[0]), static_cast<double>(extent[2]), static_cast<double>(extent[4])));
  return make_lattice(path, size_of(extent), steps, direction, Eigen::Vector3d(origin.data()) + direction * first, "");
}

/// The array that the file names as its scalars; without such a name, the first array.
const VtkElement& scalars_of(const VtkElement& piece, const VtkXmlFile& file) {
  const VtkElement* data = piece.child("PointData");
  const VtkElement* found = nullptr;
  if (data != nullptr) {
    found = data->child("DataArray");
    for (const VtkElement& array : data->children) {
      if (array.name == "DataArray" && data->attributes.contains("Scalars") &&
          array.attribute("Name") == data->attribute("Scalars")) {
        found = &array;
        break;
      }
    }
  }
  if (found == nullptr) file.fail("it has no samples at its nodes; give a volume with point data");
  if (found->attribute("NumberOfComponents", "1") != "1") file.fail("its samples are vectors; give a scalar volume");
  return *found;
}

/// Samples of one type at a part of the nodes.
struct Piece {
  Extent extent;
  Samples samples;
};

/// Puts the pieces together; neighbouring pieces share nodes. `whole` is the extent of all.
Samples assemble(std::vector<Piece>& pieces, const Extent& whole, const Lattice& lattice, const VtkXmlFile& file) {
  Samples result(pieces.front().samples.type());
  std::vector<bool> known(lattice.nodes(), false);
  result.visit([&](auto& samples) {
    samples.resize(lattice.nodes());
    for (const Piece& piece : pieces) {
      const Extent& extent = piece.extent;
      const auto size = size_of(extent);
      auto from = piece.samples.template as<SampleOf<decltype(samples)>>().begin();
      for (long long k = 0; k < size[2]; ++k) {
        for (long long j = 0; j < size[1]; ++j) {
          const auto row = static_cast<std::ptrdiff_t>(lattice.index(static_cast<int>(extent[0] - whole[0]),
                                                                     static_cast<int>(extent[2] - whole[2] + j),
                                                                     static_cast<int>(extent[4] - whole[4] + k)));
          std::copy_n(from, size[0], samples.begin() + row);
          std::fill_n(known.begin() + row, size[0], true);
          from += size[0];
        }
      }
    }
  });
  if (std::find(known.begin(), known.end(), false) != known.end()) {
    file.fail("truncated: pieces of it are missing; copy or export it again");
  }
  return result;
}

void check_extent(const Extent& extent, const Extent& whole, const VtkXmlFile& file) {
  for (std::size_t n = 0; n < 6; n += 2) {
    if (extent[n] < whole[n] || extent[n + 1] > whole[n + 1] || extent[n] > extent[n + 1]) {
      file.fail("a piece of it lies outside its whole extent; copy or export it again");
    }
  }
}

}  // namespace

VolumeFile read_vti(const std::filesystem::path& path, const VolumeChoice& /*choice*/) {
  const VtkXmlFile file(path, "ImageData");
  const Extent whole = extent_of(file.data().attribute("WholeExtent"), path);
  Volume volume;
  volume.lattice = lattice_of(file.data(), whole, path);
  std::vector<Piece> pieces;
  std::size_t nodes = 0;
  for (const VtkElement& piece : file.data().children) {
    if (piece.name != "Piece") continue;
    const Extent extent = extent_of(piece.attribute("Extent"), path);
    check_extent(extent, whole, file);
    const auto size = size_of(extent);
    const auto count = static_cast<std::size_t>(size[0] * size[1] * size[2]);
    pieces.push_back({extent, file.samples(scalars_of(piece, file), count)});
    if (pieces.back().samples.type() != pieces.front().samples.type()) {
      file.fail("its pieces have samples of different types; export it as one piece");
    }
    nodes += count;
  }
  if (nodes < volume.lattice.nodes()) file.fail("truncated: pieces of it are missing; copy or export it again");
  volume.samples =
      pieces.size() == 1 ? std::move(pieces.front().samples) : assemble(pieces, whole, volume.lattice, file);
  return {std::move(volume), {}};
}

}  // namespace isobench
