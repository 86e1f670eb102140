// The steps that cut a volume, extend it or change its outermost layers.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

#include "isobench/datasets/preparation/prepare_steps.h"
#include "isobench/foundation/error.h"

namespace isobench {

namespace {

/// True if a T can hold this value. An integer type holds whole numbers within its range; a floating-point type rounds.
template <class T>
bool holds(double value) {
  if constexpr (std::is_integral_v<T>) {
    return value == std::floor(value) && value >= static_cast<double>(std::numeric_limits<T>::min()) &&
           value < std::ldexp(1.0, std::numeric_limits<T>::digits);
  } else {
    return true;
  }
}

/// Turns samples whose type cannot hold this value into RealOf their type.
void make_room_for(double value, Samples& samples) {
  samples = samples.visit([&](auto& values) -> Samples {
    using T = SampleOf<decltype(values)>;
    if (holds<T>(value)) return std::move(values);
    std::vector<RealOf<T>> reals;
    reals.reserve(values.size());
    for (const T sample : values) reals.push_back(static_cast<RealOf<T>>(sample));
    return reals;
  });
}

template <class T>
bool is_inside(T sample) {
  return sample > T{0};
}

/// The first and the last node along each axis.
struct Box {
  Eigen::Array3i low;
  Eigen::Array3i high;
};

/// The box of the nodes > 0; its high end is below its low end if there are none.
template <class T>
Box bounding_box(const std::vector<T>& samples, const Lattice& lattice) {
  const auto [nx, ny, nz] = lattice.size;
  Box box{Eigen::Array3i(nx, ny, nz), Eigen::Array3i(-1, -1, -1)};
  for (int k = 0; k < nz; ++k) {
    for (int j = 0; j < ny; ++j) {
      const T* row = &samples[lattice.index(0, j, k)];
      const T* first = std::find_if(row, row + nx, is_inside<T>);
      if (first == row + nx) continue;
      int last = nx - 1;
      while (!is_inside(row[last])) --last;
      box.low = box.low.min(Eigen::Array3i(static_cast<int>(first - row), j, k));
      box.high = box.high.max(Eigen::Array3i(last, j, k));
    }
  }
  return box;
}

/// Copies the part of `from` that begins at node `from_first` to the place in `to` that begins at `to_first`.
template <class T>
void copy_nodes(const std::vector<T>& from, const Lattice& from_lattice, const Eigen::Array3i& from_first,
                std::vector<T>& to, const Lattice& to_lattice, const Eigen::Array3i& to_first,
                const Eigen::Array3i& size) {
  for (int k = 0; k < size[2]; ++k) {
    for (int j = 0; j < size[1]; ++j) {
      std::copy_n(&from[from_lattice.index(from_first[0], from_first[1] + j, from_first[2] + k)], size[0],
                  &to[to_lattice.index(to_first[0], to_first[1] + j, to_first[2] + k)]);
    }
  }
}

/// Nodes to add before the first and after the last one of each axis.
struct Margins {
  Eigen::Array3i low = Eigen::Array3i::Zero();
  Eigen::Array3i high = Eigen::Array3i::Zero();
};

void pad_sides(Volume& volume, const Margins& margins, double value) {
  const Lattice& lattice = volume.lattice;
  Lattice padded = lattice;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<Eigen::Index>(axis);
    const long long count = static_cast<long long>(lattice.size[axis]) + margins.low[a] + margins.high[a];
    if (count > std::numeric_limits<int>::max())
      throw DataError("pad: the volume would have more nodes along an axis than 2^31 - 1; add fewer voxels");
    padded.size[axis] = static_cast<int>(count);
  }
  check_size(padded.size);
  padded.origin = lattice.to_world(-margins.low.cast<double>().matrix().cwiseProduct(lattice.spacing));
  make_room_for(value, volume.samples);
  const Eigen::Array3i size(lattice.size[0], lattice.size[1], lattice.size[2]);
  volume.samples = volume.samples.visit([&](const auto& samples) -> Samples {
    using T = SampleOf<decltype(samples)>;
    std::vector<T> result(padded.nodes(), static_cast<T>(value));
    copy_nodes(samples, lattice, Eigen::Array3i::Zero(), result, padded, margins.low, size);
    return result;
  });
  volume.lattice = padded;
}

/// Where and how an object reaches the border of a volume.
struct Leaving {
  Margins margins;  // the layers that close it
  int sides = 0;
  double area = 0.0;           // mm², of the outermost nodes inside
  std::vector<double> values;  // of the nodes inside in the two outermost layers
};

/// Looks at the two outermost layers of one side.
template <class T>
void look_at_side(const std::vector<T>& samples, const Lattice& lattice, const CloseBorder& step, std::size_t axis,
                  bool high, Leaving& leaving) {
  constexpr int looked_at = 2;  // the cubic spline reaches two nodes beyond a point
  constexpr int added = 3;
  const std::size_t u = (axis + 1) % 3;
  const std::size_t v = (axis + 2) % 3;
  const double face = lattice.spacing.prod() / lattice.spacing[static_cast<Eigen::Index>(axis)];
  bool leaves = false;
  for (int layer = 0; layer < std::min(looked_at, lattice.size[axis]); ++layer) {
    std::array<int, 3> node{};
    node[axis] = high ? lattice.size[axis] - 1 - layer : layer;
    for (node[v] = 0; node[v] < lattice.size[v]; ++node[v]) {
      for (node[u] = 0; node[u] < lattice.size[u]; ++node[u]) {
        const auto value = static_cast<double>(samples[lattice.index(node[0], node[1], node[2])]);
        if (!(step.object_below ? value < step.isovalue : value > step.isovalue)) continue;
        leaves = true;
        leaving.values.push_back(value);
        if (layer == 0) leaving.area += face;
      }
    }
  }
  if (!leaves) return;
  ++leaving.sides;
  (high ? leaving.margins.high : leaving.margins.low)[static_cast<Eigen::Index>(axis)] = added;
}

/// A value that is as far outside the object as the median of the values is inside, and at least a tenth of the
/// samples' range; a whole number if the median is one.
double closing_value(std::vector<double>& inside, const Range& range, const CloseBorder& step) {
  const auto middle = inside.begin() + static_cast<std::ptrdiff_t>(inside.size() / 2);
  std::nth_element(inside.begin(), middle, inside.end());
  const double depth = std::max(std::abs(*middle - step.isovalue), 0.1 * (range.max - range.min));
  const double most = std::numeric_limits<float>::max();  // F is made of floats
  const double outside = std::clamp(step.object_below ? step.isovalue + depth : step.isovalue - depth, -most, most);
  if (*middle != std::floor(*middle)) return outside;
  return step.object_below ? std::ceil(outside) : std::floor(outside);
}

}  // namespace

void check_size(const std::array<int, 3>& size) {
  // Files have the same limit: 2^40 nodes are more than any volume has, and their number fits into 64 bits.
  if (static_cast<double>(size[0]) * size[1] * size[2] > static_cast<double>(1LL << 40U)) {
    throw DataError(fmt::format("a volume of {} × {} × {} nodes would be too large; pad or resample it less", size[0],
                                size[1], size[2]));
  }
}

void crop(Volume& volume, int margin) {
  const Lattice& lattice = volume.lattice;
  const Eigen::Array3i size_before(lattice.size[0], lattice.size[1], lattice.size[2]);
  Box box = volume.samples.visit([&](const auto& samples) { return bounding_box(samples, lattice); });
  if (box.high[0] < 0) throw DataError("crop: no sample is > 0; check the threshold or the labels before it");
  margin = std::clamp(margin, 0, size_before.maxCoeff());
  box.low = (box.low - margin).max(0);
  box.high = (box.high + margin).min(size_before - 1);
  const Eigen::Array3i size = box.high - box.low + 1;
  Lattice cropped = lattice;
  cropped.size = {size[0], size[1], size[2]};
  cropped.origin = lattice.to_world(box.low.cast<double>().matrix().cwiseProduct(lattice.spacing));
  volume.samples = volume.samples.visit([&](const auto& samples) -> Samples {
    std::vector<SampleOf<decltype(samples)>> result(cropped.nodes());
    copy_nodes(samples, lattice, box.low, result, cropped, Eigen::Array3i::Zero(), size);
    return result;
  });
  volume.lattice = cropped;
}

void pad(Volume& volume, int voxels, double value) {
  if (voxels < 0) throw DataError("pad: the number of voxels is negative; give one of at least 0");
  pad_sides(volume, {Eigen::Array3i::Constant(voxels), Eigen::Array3i::Constant(voxels)}, value);
}

void close_border(Volume& volume, const CloseBorder& step, Monitor& monitor) {
  Leaving leaving;
  volume.samples.visit([&](const auto& samples) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const bool high : {false, true}) look_at_side(samples, volume.lattice, step, axis, high, leaving);
    }
  });
  if (leaving.sides == 0) return;
  pad_sides(volume, leaving.margins, closing_value(leaving.values, sample_range(volume), step));
  monitor.note(fmt::format("the object reaches the volume's border on {} side{}; {:.4g} mm² of it were closed, outside",
                           leaving.sides, leaving.sides == 1 ? "" : "s", leaving.area));
}

}  // namespace isobench
