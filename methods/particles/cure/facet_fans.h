// The facets around each point of a triangulation.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "isobench/methods/closing/labelled_delaunay.h"

namespace isobench::particles {

class FacetFans {
 public:
  /// Keeps a reference to the facets. `points` is the number of points.
  FacetFans(const std::vector<LabelledDelaunay::Facet>& facets, std::size_t points);

  /// Indices of the facets at a point.
  std::span<const std::uint32_t> facets_at(std::size_t point) const {
    return {items_.data() + first_[point], first_[point + 1] - first_[point]};
  }
  /// Whether the facets at a point form one closed fan. The point has at least one facet.
  bool is_closed_fan(std::uint32_t point) const;

 private:
  const std::vector<LabelledDelaunay::Facet>& facets_;
  std::vector<std::uint32_t> first_;
  std::vector<std::uint32_t> items_;
};

}  // namespace isobench::particles
