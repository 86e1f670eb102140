// VTI: samples at the points or in the cells of an image, in one piece or in several.
#include "isobench/datasets/formats/vtk/read_vti.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

#include "isobench/datasets/formats/reading/header_values.h"
#include "isobench/datasets/formats/reading/read_samples.h"
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

/// Where samples are: at the points of an image, or in its cells, which become nodes in their middles.
enum class Where { points, cells };

/// The extent of the samples. An image that is flat along an axis has one layer of cells there.
Extent extent_at(Where place, Extent extent) {
  if (place == Where::points) return extent;
  for (std::size_t n = 1; n < 6; n += 2) extent[n] = std::max(extent[n] - 1, extent[n - 1]);
  return extent;
}

std::array<long long, 3> size_of(const Extent& extent) {
  return {extent[1] - extent[0] + 1, extent[3] - extent[2] + 1, extent[5] - extent[4] + 1};
}

Lattice lattice_of(const VtkElement& image, const Extent& extent, Where place, const std::filesystem::path& path) {
  const std::vector<double> spacing = numbers_in(image.attribute("Spacing", "1 1 1"), 3, path, "Spacing");
  const std::vector<double> origin = numbers_in(image.attribute("Origin", "0 0 0"), 3, path, "Origin");
  const std::vector<double> cosines =
      numbers_in(image.attribute("Direction", "1 0 0 0 1 0 0 0 1"), 9, path, "Direction");
  const Eigen::Matrix3d direction = Eigen::Map<const Eigen::Matrix3d>(cosines.data()).transpose();
  const Eigen::Vector3d steps(spacing.data());
  // The extent need not start at 0.
  Eigen::Vector3d first(static_cast<double>(extent[0]), static_cast<double>(extent[2]), static_cast<double>(extent[4]));
  if (place == Where::cells) first.array() += 0.5;
  return make_lattice(path, size_of(extent_at(place, extent)), steps, direction,
                      Eigen::Vector3d(origin.data()) + direction * steps.cwiseProduct(first), "");
}

/// An array of numbers in a piece.
struct NamedArray {
  std::string name;
  Where place = Where::points;
  std::size_t components = 1;
  bool is_scalars = false;  ///< the file names it as its scalars
  const VtkElement* element = nullptr;
};

std::string describe(const NamedArray& array) {
  return fmt::format("'{}' ({}{})", array.name, array.place == Where::points ? "at points" : "in cells",
                     array.components == 1 ? "" : fmt::format(", {} components", array.components));
}

std::vector<NamedArray> arrays_of(const VtkElement& piece, const VtkXmlFile& file) {
  std::vector<NamedArray> arrays;
  for (const auto& [name, place] : {std::pair{"PointData", Where::points}, std::pair{"CellData", Where::cells}}) {
    const VtkElement* data = piece.child(name);
    if (data == nullptr) continue;
    for (const VtkElement& array : data->children) {
      if (array.name != "DataArray" || !VtkXmlFile::is_numeric(array)) continue;
      const std::size_t components =
          array.attributes.contains("NumberOfComponents") ? file.count(array, "NumberOfComponents") : 1;
      const std::string own = array.attribute("Name");
      arrays.push_back({own, place, std::max<std::size_t>(components, 1),
                        data->attributes.contains("Scalars") && data->attribute("Scalars") == own, &array});
    }
  }
  return arrays;
}

std::string list_of(const std::vector<NamedArray>& arrays) {
  std::string text;
  for (const NamedArray& array : arrays) text += (text.empty() ? "" : ", ") + describe(array);
  return text;
}

/// The array asked for; else the one that the file names as its scalars; else the only one that is scalar; else the
/// only one. Throws DataError with the names of all if none of these is.
NamedArray choose_array(const std::vector<NamedArray>& arrays, const std::string& asked, const VtkXmlFile& file) {
  if (arrays.empty()) file.fail("it has no samples at its points or in its cells; give a volume with data");
  std::vector<NamedArray> found;
  const auto take = [&](auto&& is_meant) {
    if (found.empty()) std::copy_if(arrays.begin(), arrays.end(), std::back_inserter(found), is_meant);
  };
  if (!asked.empty()) {
    take([&](const NamedArray& array) { return array.name == asked; });
    if (found.empty()) {
      std::vector<std::string> names;
      for (const NamedArray& array : arrays) names.push_back(array.name);
      file.fail(fmt::format("its arrays are {}, and none is '{}'{}", list_of(arrays), asked, suggestion(asked, names)));
    }
    if (found.size() > 1) file.fail(fmt::format("it has several arrays '{}'; give a file with one of them", asked));
    return found.front();
  }
  take([](const NamedArray& array) { return array.is_scalars; });
  if (found.empty() && arrays.size() == 1) return arrays.front();
  take([](const NamedArray& array) { return array.components == 1; });
  if (found.size() != 1) file.fail(fmt::format("it has several arrays, {}; choose one with --array", list_of(arrays)));
  return found.front();
}

/// The samples of the chosen array in one piece; of vectors, the chosen component.
Samples samples_in(const NamedArray& array, std::size_t count, const VolumeChoice& choice,
                   const std::filesystem::path& path, const VtkXmlFile& file) {
  if (array.components > (std::size_t{1} << 40U) / std::max<std::size_t>(count, 1))
    file.fail("its arrays are larger than any file; copy or export it again");
  const std::size_t component = place_on_axis(choice.component, array.components, "component", path);
  Samples all = file.samples(*array.element, count * array.components);
  if (array.components == 1) return all;
  return all.visit([&](const auto& values) -> Samples {
    std::vector<SampleOf<decltype(values)>> one(count);
    for (std::size_t n = 0; n < count; ++n) one[n] = values[n * array.components + component];
    return one;
  });
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

VolumeFile read_vti(const std::filesystem::path& path, const VolumeChoice& choice) {
  const VtkXmlFile file(path, "ImageData");
  const Extent whole = extent_of(file.data().attribute("WholeExtent"), path);
  lattice_of(file.data(), whole, Where::points, path);  // throws before pieces are looked for
  const VtkElement* first = file.data().child("Piece");
  if (first == nullptr) file.fail("truncated: pieces of it are missing; copy or export it again");
  const std::vector<NamedArray> arrays = arrays_of(*first, file);
  const NamedArray chosen = choose_array(arrays, choice.array, file);
  VolumeFile result;
  Volume& volume = result.volume;
  volume.lattice = lattice_of(file.data(), whole, chosen.place, path);
  const Extent whole_of_samples = extent_at(chosen.place, whole);
  std::vector<Piece> pieces;
  std::size_t nodes = 0;
  for (const VtkElement& piece : file.data().children) {
    if (piece.name != "Piece") continue;
    const Extent points = extent_of(piece.attribute("Extent"), path);
    check_extent(points, whole, file);
    const Extent extent = extent_at(chosen.place, points);
    const auto size = size_of(extent);
    const auto count = static_cast<std::size_t>(size[0] * size[1] * size[2]);
    const std::vector<NamedArray> here = arrays_of(piece, file);
    const auto same = std::find_if(here.begin(), here.end(), [&](const NamedArray& array) {
      return array.name == chosen.name && array.place == chosen.place && array.components == chosen.components;
    });
    if (same == here.end()) file.fail(fmt::format("a piece of it has no array {}; export it again", describe(chosen)));
    pieces.push_back({extent, samples_in(*same, count, choice, path, file)});
    if (pieces.back().samples.type() != pieces.front().samples.type()) {
      file.fail("its pieces have samples of different types; export it as one piece");
    }
    nodes += count;
  }
  if (nodes < volume.lattice.nodes()) file.fail("truncated: pieces of it are missing; copy or export it again");
  volume.samples =
      pieces.size() == 1 ? std::move(pieces.front().samples) : assemble(pieces, whole_of_samples, volume.lattice, file);
  if (choice.array.empty() && arrays.size() > 1)
    result.notes.push_back(
        fmt::format("{}: of its arrays, {}, {} is taken", path.string(), list_of(arrays), describe(chosen)));
  return result;
}

}  // namespace isobench
