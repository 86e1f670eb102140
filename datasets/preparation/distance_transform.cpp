#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "isobench/datasets/preparation/prepare_steps.h"
#include "isobench/foundation/error.h"

namespace isobench {

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

/// The lower envelope of the parabolas (x − x_q)² + height_q of the nodes q of one row.
class Envelope {
 public:
  explicit Envelope(std::size_t nodes) : nodes_(nodes), heights_(nodes), from_(nodes) {}

  void clear() { count_ = 0; }

  /// Precondition: nodes come in ascending order. Positions are in mm.
  void add(std::size_t node, double position, double height) {
    double from = -std::numeric_limits<double>::infinity();
    while (count_ > 0) {
      const double last = positions_at(count_ - 1);
      from = ((height + position * position) - (heights_[count_ - 1] + last * last)) / (2.0 * (position - last));
      if (from > from_[count_ - 1]) break;
      --count_;
      from = -std::numeric_limits<double>::infinity();
    }
    nodes_[count_] = node;
    heights_[count_] = height;
    from_[count_] = from;
    ++count_;
  }

  bool empty() const { return count_ == 0; }
  void rewind() { current_ = 0; }
  /// The envelope's height at x. Precondition: x does not decrease between two calls of rewind().
  double at(double x) {
    while (current_ + 1 < count_ && from_[current_ + 1] < x) ++current_;
    const double distance = x - positions_at(current_);
    return distance * distance + heights_[current_];
  }
  void set_spacing(double spacing) { spacing_ = spacing; }

 private:
  double positions_at(std::size_t entry) const { return spacing_ * static_cast<double>(nodes_[entry]); }

  std::vector<std::size_t> nodes_;
  std::vector<double> heights_;
  std::vector<double> from_;
  std::size_t count_ = 0;
  std::size_t current_ = 0;
  double spacing_ = 1.0;
};

/// One row of signed squared distances: of a node inside (> 0) to the nearest node outside, of a node outside (< 0) to
/// the nearest node inside. For each of the two transforms the nodes of the other side have distance 0, so that both
/// share the array.
void transform_row(float* row, std::size_t count, std::size_t stride, double spacing, Envelope& envelope) {
  for (const float sign : {1.0F, -1.0F}) {
    envelope.clear();
    for (std::size_t n = 0; n < count; ++n) {
      const float squared = std::max(sign * row[n * stride], 0.0F);
      if (squared < infinity) envelope.add(n, spacing * static_cast<double>(n), squared);
    }
    if (envelope.empty()) continue;
    envelope.rewind();
    for (std::size_t n = 0; n < count; ++n) {
      float& value = row[n * stride];
      if (sign * value > 0.0F) value = sign * static_cast<float>(envelope.at(spacing * static_cast<double>(n)));
    }
  }
}

/// All rows along one axis. Sheets of rows do not depend on each other.
void transform_axis(FloatVolume& volume, int axis) {
  const auto nx = static_cast<std::size_t>(volume.lattice.size[0]);
  const auto ny = static_cast<std::size_t>(volume.lattice.size[1]);
  const auto nz = static_cast<std::size_t>(volume.lattice.size[2]);
  const std::size_t strides[] = {1, nx, nx * ny};
  const auto count = static_cast<std::size_t>(volume.lattice.size[static_cast<std::size_t>(axis)]);
  const double spacing = volume.lattice.spacing[axis];
  const std::size_t sheets = axis == 2 ? ny : nz;
  const std::size_t sheet_stride = axis == 2 ? nx : nx * ny;
  const std::size_t rows = axis == 0 ? ny : nx;
  const std::size_t row_stride = axis == 0 ? nx : 1;
  tbb::parallel_for(std::size_t{0}, sheets, [&](std::size_t sheet) {
    Envelope envelope(count);
    envelope.set_spacing(spacing);
    for (std::size_t row = 0; row < rows; ++row) {
      float* first = volume.samples.data() + sheet * sheet_stride + row * row_stride;
      transform_row(first, count, strides[axis], spacing, envelope);
    }
  });
}

}  // namespace

FloatVolume signed_distance(Volume volume, Monitor& monitor) {
  FloatVolume result{std::move(volume.lattice), {}};
  std::vector<float>& squared = result.samples;
  volume.samples.visit([&](const auto& samples) {
    squared.reserve(samples.size());
    for (const auto sample : samples) squared.push_back(sample > 0 ? infinity : -infinity);
  });
  volume.samples = Samples();  // not needed any more
  const auto inside = std::count(squared.begin(), squared.end(), infinity);
  if (inside == 0) throw DataError("signed distance: no sample is > 0; select or threshold an object first");
  if (static_cast<std::size_t>(inside) == squared.size()) {
    throw DataError("signed distance: every sample is > 0, there is no outside; pad the volume first");
  }
  for (int axis = 0; axis < 3; ++axis) {
    monitor.progress(axis / 3.0);
    transform_axis(result, axis);
  }
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, squared.size(), 65536), [&](const auto& range) {
    for (std::size_t n = range.begin(); n < range.end(); ++n) {
      squared[n] = std::copysign(std::sqrt(std::abs(squared[n])), squared[n]);
    }
  });
  return result;
}

}  // namespace isobench
