#include "isobench/methods/particles/cure/cure.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>

#include "isobench/methods/particles/cure/dual_edge.h"
#include "isobench/methods/particles/cure/lattice_components.h"
#include "isobench/methods/particles/cure/local_relaxation.h"

namespace isobench::particles {

namespace {

using Facet = LabelledDelaunay::Facet;

constexpr double least_facet_cosine = 0.5;  // facets tilted further from a corner's normal are wrong
constexpr double least_gap = 0.15;          // of a new particle to others around it, times the spacing there
constexpr double least_gap_to_all = 0.01;   // and to any

// Which facets each particle is a corner of.
struct Fans {
  std::vector<std::uint32_t> first;
  std::vector<std::uint32_t> items;

  Fans(const std::vector<Facet>& facets, std::size_t points) : first(points + 1, 0), items(3 * facets.size()) {
    for (const Facet& facet : facets) {
      for (const std::uint32_t corner : facet.corners) ++first[corner + 1];
    }
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
    for (std::size_t n = 0; n < facets.size(); ++n) {
      for (const std::uint32_t corner : facets[n].corners) items[next[corner]++] = static_cast<std::uint32_t>(n);
    }
  }
  std::size_t count(std::size_t point) const { return first[point + 1] - first[point]; }
};

// Whether the triangles at a point form one closed fan: each leads from one neighbour to another, and following them
// must come round once through all.
bool one_fan(const std::vector<Facet>& facets, const Fans& fans, std::uint32_t point) {
  std::vector<std::array<std::uint32_t, 2>> steps;
  for (std::uint32_t i = fans.first[point]; i < fans.first[point + 1]; ++i) {
    const Triangle& t = facets[fans.items[i]].corners;
    const std::size_t at = t[0] == point ? 0 : t[1] == point ? 1 : 2;
    steps.push_back({t[(at + 1) % 3], t[(at + 2) % 3]});
  }
  std::uint32_t here = steps.front()[0];
  for (std::size_t taken = 0; taken < steps.size(); ++taken) {
    const auto leads_on = [here](const auto& step) { return step[0] == here; };
    const auto step = std::find_if(steps.begin(), steps.end(), leads_on);
    if (step == steps.end() || std::count_if(steps.begin(), steps.end(), leads_on) > 1) return false;
    here = (*step)[1];
    if (here == steps.front()[0]) return taken + 1 == steps.size();
  }
  return false;
}

bool is_tilted(const Facet& facet, const Particles& particles) {
  const auto& [a, b, c] = facet.corners;
  const Eigen::Vector3d normal =
      (particles.points[b] - particles.points[a]).cross(particles.points[c] - particles.points[a]).normalized();
  return std::any_of(facet.corners.begin(), facet.corners.end(),
                     [&](std::uint32_t corner) { return normal.dot(particles.normals[corner]) < least_facet_cosine; });
}

// What is wrong, and where.
struct Findings {
  Defects defects;
  std::vector<std::uint32_t> facets;    // to be refined, ascending
  std::vector<std::uint32_t> isolated;  // points without a facet
  std::vector<std::uint32_t> pinched;   // points with more than one fan
};

class Curing {
 public:
  Curing(const Isosurface& surface, const Spacing& spacing, SizeBounds* smaller, const TriangleMesh& lattice_mesh,
         Particles& particles, LabelledDelaunay& delaunay, const CureLimits& limits)
      : surface_(surface),
        spacing_(spacing),
        smaller_(smaller),
        limits_(limits),
        components_(lattice_mesh),
        particles_(particles),
        delaunay_(delaunay),
        component_(components_.of(particles.points)),
        used_(particles.size(), 1),
        suspects_(particles.size()) {
    std::iota(suspects_.begin(), suspects_.end(), 0U);
  }

  Cure run(Monitor& monitor) {
    Findings found = look();
    cure_.before = found.defects;
    const int relaxations = smaller_ != nullptr ? limits_.relaxations : 0;
    while (found.defects.all() > 0 && cure_.relaxations < relaxations) {
      monitor.progress(static_cast<double>(cure_.relaxations) / relaxations);
      add(found);
      if (places_.empty()) break;
      relax(monitor);
      found = look();
    }
    for (int round = 0; round < limits_.rounds && found.defects.all() > 0; ++round) {
      monitor.check();
      if (add(found) == 0) break;
      ++cure_.rounds;
      found = look();
    }
    cut(found);
    cure_.after = found.defects;
    return cure_;
  }

 private:
  // Points do no more: cuts what is still pinched.
  void cut(Findings& found) {
    constexpr int cuts = 10;
    for (int cut = 0; cut < cuts && !found.pinched.empty(); ++cut) {
      std::size_t flipped = 0;
      for (const std::uint32_t point : found.pinched) flipped += delaunay_.flip_label_at(point) ? 1 : 0;
      cure_.flipped += flipped;
      if (flipped == 0) break;
      suspects_.resize(particles_.size());
      std::iota(suspects_.begin(), suspects_.end(), 0U);
      found = look();
    }
  }

  // Judges what is at the suspects; all else was found right before and has not changed.
  Findings look() {
    facets_ = suspects_.size() == particles_.size() ? delaunay_.facets() : delaunay_.facets_at(suspects_);
    const Fans fans(facets_, particles_.size());
    std::vector<char> wrong(facets_.size(), 0);
    std::vector<char> crossed(facets_.size(), 0);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, facets_.size(), 1024), [&](const auto& range) {
      for (std::size_t n = range.begin(); n < range.end(); ++n) {
        wrong[n] = is_tilted(facets_[n], particles_) ? 1 : 0;
        crossed[n] = crossings(facets_[n], surface_) > 1 ? 1 : 0;
      }
    });
    std::vector<char> pinched(suspects_.size(), 0);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, suspects_.size(), 1024), [&](const auto& range) {
      for (std::size_t n = range.begin(); n < range.end(); ++n)
        pinched[n] = fans.count(suspects_[n]) > 0 && !one_fan(facets_, fans, suspects_[n]) ? 1 : 0;
    });

    Findings found;
    found.defects.tilted = static_cast<std::size_t>(std::count(wrong.begin(), wrong.end(), 1));
    found.defects.crossed = static_cast<std::size_t>(std::count(crossed.begin(), crossed.end(), 1));
    for (std::size_t s = 0; s < suspects_.size(); ++s) {
      const std::uint32_t n = suspects_[s];
      used_[n] = fans.count(n) > 0 ? 1 : 0;
      if (used_[n] == 0) found.isolated.push_back(n);
      if (pinched[s] == 0) continue;
      found.pinched.push_back(n);
      for (std::uint32_t i = fans.first[n]; i < fans.first[n + 1]; ++i) wrong[fans.items[i]] = 1;
    }
    found.defects.pinched = found.pinched.size();
    found.defects.isolated = found.isolated.size();
    for (std::uint32_t n = 0; n < facets_.size(); ++n) {
      if (wrong[n] != 0 || crossed[n] != 0) found.facets.push_back(n);
    }
    lost_ = components_.without(component_, used_);
    found.defects.lost = lost_.size();

    suspects_ = found.isolated;
    for (const std::uint32_t n : found.facets)
      suspects_.insert(suspects_.end(), facets_[n].corners.begin(), facets_[n].corners.end());
    return found;
  }

  bool is_near(const Eigen::Vector3d& x, std::uint32_t particle, double gap) const {
    return (particles_.points[particle] - x).norm() <= gap * particles_.spacing[particle];
  }

  // Of one that is to be added: what leads to it may lead to the same again, from another sheet and in a later round.
  void consider(const Eigen::Vector3d& x, std::uint32_t near) {
    if (!is_near(x, delaunay_.nearest(x, near), least_gap_to_all)) added_.push_back(x);
  }

  // Adds particles for all findings; how many. Says, too, where something is wrong and none more fits.
  std::size_t add(const Findings& found) {
    added_.clear();
    places_.clear();
    for (const std::uint32_t n : found.facets) {
      const std::size_t before = added_.size();
      pierce(facets_[n]);
      if (added_.size() == before) places_.push_back(middle(facets_[n]));
    }
    for (const std::uint32_t n : found.isolated) {
      const std::size_t before = added_.size();
      surround(n);
      if (added_.size() == before) places_.push_back(particles_.points[n]);
    }
    for (const auto& component : lost_) {
      for (const Eigen::Vector3d& x : component) {
        const auto foot = surface_.project(x);
        if (foot) consider(*foot, 0);
      }
    }
    const Particles fresh = make_particles(surface_, spacing_, thinned());
    exchange({}, fresh);
    places_.insert(places_.end(), fresh.points.begin(), fresh.points.end());
    cure_.inserted += fresh.size();
    return fresh.size();
  }

  void relax(Monitor& monitor) {
    const Exchange relaxed = relax_around(places_, surface_, spacing_, *smaller_, limits_.least, particles_, monitor);
    exchange(relaxed.gone, relaxed.fresh);
    cure_.relaxed += relaxed.fresh.size();
    ++cure_.relaxations;
  }

  // Takes particles away, adds others, and suspects what has to do with them.
  void exchange(const std::vector<std::uint32_t>& gone, const Particles& fresh) {
    std::vector<char> goes(particles_.size(), 0);
    for (const std::uint32_t n : gone) goes[n] = 1;
    std::vector<std::uint32_t> now(particles_.size());
    std::transform_exclusive_scan(goes.begin(), goes.end(), now.begin(), 0U, std::plus<>(),
                                  [](char goes_now) { return goes_now != 0 ? 0U : 1U; });
    particles_.erase(goes);
    erase_marked(component_, goes);
    erase_marked(used_, goes);
    for (std::size_t n = 0; n < fresh.size(); ++n) particles_.add(fresh, n);
    const std::vector<std::uint32_t> fresh_components = components_.of(fresh.points);
    component_.insert(component_.end(), fresh_components.begin(), fresh_components.end());
    used_.resize(particles_.size(), 1);

    std::erase_if(suspects_, [&](std::uint32_t n) { return goes[n] != 0; });
    for (std::uint32_t& n : suspects_) n = now[n];
    const std::vector<std::uint32_t> changed = delaunay_.replace(gone, fresh.points);
    suspects_.insert(suspects_.end(), changed.begin(), changed.end());
    std::sort(suspects_.begin(), suspects_.end());
    suspects_.erase(std::unique(suspects_.begin(), suspects_.end()), suspects_.end());
  }

  // Where a facet's dual edge crosses the surface.
  void pierce(const Facet& facet) {
    for (const Eigen::Vector3d& x : crossing_points(facet, surface_)) {
      const bool crowds = std::any_of(facet.corners.begin(), facet.corners.end(),
                                      [&](std::uint32_t corner) { return is_near(x, corner, least_gap); });
      if (!crowds) consider(x, facet.corners[0]);
    }
  }

  Eigen::Vector3d middle(const Facet& facet) const {
    const auto& [a, b, c] = facet.corners;
    const Eigen::Vector3d mean = (particles_.points[a] + particles_.points[b] + particles_.points[c]) / 3.0;
    return surface_.project(mean).value_or(particles_.points[a]);
  }

  // A ring about a particle that the surface passes by: with it, the particle's cells are small against the sheet.
  void surround(std::uint32_t n) {
    const Eigen::Vector3d& normal = particles_.normals[n];
    const Eigen::Vector3d u = normal.unitOrthogonal();
    const Eigen::Vector3d v = normal.cross(u);
    constexpr int corners = 6;
    for (int corner = 0; corner < corners; ++corner) {
      const double angle = 2.0 * M_PI * corner / corners;
      const Eigen::Vector3d out = std::cos(angle) * u + std::sin(angle) * v;
      const auto foot = surface_.project(particles_.points[n] + 0.5 * particles_.spacing[n] * out);
      if (foot && !is_near(*foot, n, least_gap)) consider(*foot, n);
    }
  }

  // Of those that are to be added: each that no earlier one is as good as at.
  std::vector<Eigen::Vector3d> thinned() const {
    std::vector<double> reach(added_.size());
    for (std::size_t n = 0; n < added_.size(); ++n) reach[n] = least_gap * spacing_(added_[n]);
    const NeighbourLists near = find_neighbours(added_, reach);
    std::vector<char> kept(added_.size(), 0);
    std::vector<Eigen::Vector3d> result;
    for (std::size_t n = 0; n < added_.size(); ++n) {
      const auto others = near.of(n);
      kept[n] = std::none_of(others.begin(), others.end(), [&](std::uint32_t m) { return m < n && kept[m] != 0; });
      if (kept[n] != 0) result.push_back(added_[n]);
    }
    return result;
  }

  const Isosurface& surface_;
  const Spacing& spacing_;
  SizeBounds* smaller_;
  const CureLimits limits_;
  LatticeComponents components_;
  Particles& particles_;
  LabelledDelaunay& delaunay_;
  std::vector<std::uint32_t> component_;  // of each particle
  std::vector<char> used_;                // of each particle: it has a facet
  std::vector<std::uint32_t> suspects_;   // particles whose facets are to be judged
  std::vector<Facet> facets_;             // those at what was suspect
  std::vector<std::vector<Eigen::Vector3d>> lost_;
  std::vector<Eigen::Vector3d> added_;
  std::vector<Eigen::Vector3d> places_;  // where particles were last added, or none more fitted
  Cure cure_;
};

}  // namespace

Cure cure(const Isosurface& surface, const Spacing& spacing, SizeBounds* smaller, const TriangleMesh& lattice_mesh,
          Particles& particles, LabelledDelaunay& delaunay, const CureLimits& limits, Monitor& monitor) {
  return Curing(surface, spacing, smaller, lattice_mesh, particles, delaunay, limits).run(monitor);
}

}  // namespace isobench::particles
