#include "isobench/methods/particles/cure/facet_fans.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace isobench::particles {

using Facet = LabelledDelaunay::Facet;

FacetFans::FacetFans(const std::vector<Facet>& facets, std::size_t points)
    : facets_(facets), first_(points + 1, 0), items_(3 * facets.size()) {
  for (const Facet& facet : facets) {
    for (const std::uint32_t corner : facet.corners) ++first_[corner + 1];
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t n = 0; n < facets.size(); ++n) {
    for (const std::uint32_t corner : facets[n].corners) items_[next[corner]++] = static_cast<std::uint32_t>(n);
  }
}

bool FacetFans::is_closed_fan(std::uint32_t point) const {
  // Each facet leads from one neighbour of the point to another. If the fan is closed, a walk from the first neighbour
  // uses each facet once and ends at the first neighbour.
  std::vector<std::array<std::uint32_t, 2>> steps;
  for (const std::uint32_t n : facets_at(point)) {
    const Triangle& t = facets_[n].corners;
    const std::size_t at = t[0] == point ? 0 : t[1] == point ? 1 : 2;
    steps.push_back({t[(at + 1) % 3], t[(at + 2) % 3]});
  }
  std::uint32_t here = steps.front()[0];
  for (std::size_t taken = 0; taken < steps.size(); ++taken) {
    const auto starts_here = [here](const auto& step) { return step[0] == here; };
    const auto step = std::find_if(steps.begin(), steps.end(), starts_here);
    if (step == steps.end() || std::count_if(steps.begin(), steps.end(), starts_here) > 1) return false;
    here = (*step)[1];
    if (here == steps.front()[0]) return taken + 1 == steps.size();
  }
  return false;
}

}  // namespace isobench::particles
