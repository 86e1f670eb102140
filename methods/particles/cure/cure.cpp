#include "isobench/methods/particles/cure/cure.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>
#include <set>
#include <span>

#include "isobench/methods/mesh/component_match.h"
#include "isobench/methods/particles/cure/dual_edge_crossings.h"
#include "isobench/methods/particles/cure/facet_fans.h"
#include "isobench/methods/particles/cure/local_relaxation.h"
#include "isobench/methods/particles/cure/lost_components.h"
#include "isobench/methods/particles/sampling/component_seeds.h"

namespace isobench::particles {

namespace {

using Facet = LabelledDelaunay::Facet;

constexpr int most_cuts = 10;               // rounds that change the labels of cells at pinches
constexpr double least_facet_cosine = 0.5;  // between a facet and the normal at a corner; below, the facet is tilted
constexpr double least_gap = 0.15;          // from a new particle to those around it, times the spacing there
constexpr double least_gap_to_all = 0.01;   // from a new particle to any other, times the spacing there

bool is_tilted(const Facet& facet, const Particles& particles) {
  const auto& [a, b, c] = facet.corners;
  const Eigen::Vector3d normal =
      (particles.points[b] - particles.points[a]).cross(particles.points[c] - particles.points[a]).normalized();
  return std::any_of(facet.corners.begin(), facet.corners.end(),
                     [&](std::uint32_t corner) { return normal.dot(particles.normals[corner]) < least_facet_cosine; });
}

// The defects and their places.
struct Findings {
  Defects defects;
  std::vector<std::uint32_t> facets;    // defective facets, indices into Curing::facets_, ascending
  std::vector<std::uint32_t> isolated;  // points without a facet
  std::vector<std::uint32_t> pinched;   // points whose facets do not form one closed fan
};

// A cell of the triangulation whose label is changed: LabelledDelaunay::flip_label_at().
struct Cut {
  std::uint32_t point = 0;
  std::size_t rank = 0;
};

class Curing {
 public:
  Curing(SizedSurface& sized, const CertifiedTopology& topology, Particles& particles, LabelledDelaunay& delaunay,
         const CureOptions& options)
      : sized_(sized),
        options_(options),
        converges_(sized.surface().kernel() != Kernel::catmull_rom),
        topology_(topology),
        particles_(particles),
        delaunay_(delaunay),
        component_(components_at(topology, particles.points)),
        has_facet_(particles.size(), 1),
        lost_components_(sized.surface(), topology) {
    check_all_next();
  }

  CureResult run(Monitor& monitor) {
    Findings found = find_defects();
    result_.before = found.defects;
    set_ends(found);
    const int most_comparisons = options_.rounds > 0 || options_.relaxations > 0 ? 3 : 0;
    for (int comparison = 0;; ++comparison) {
      remove_defects(found, monitor);
      const std::vector<std::vector<Eigen::Vector3d>> places = compare(found);
      if (places.empty() || comparison == most_comparisons || is_endless(found)) break;
      proposed_.clear();
      relaxation_centres_.clear();
      for (const auto& of_component : places) {
        for (const Eigen::Vector3d& x : of_component) propose(x, 0);
      }
      if (insert_proposals() == 0) break;
      if (options_.relaxations > 0) relax(monitor);
      check_all_next();
      found = find_defects();
    }
    cut_last_pinches(found);
    result_.after = found.defects;
    result_.gave_up = found.defects.all() > 0 && is_endless(found);
    return result_;
  }

 private:
  void remove_defects(Findings& found, Monitor& monitor) {
    const int relaxations = converges_ ? options_.relaxations : options_.relaxations / 2;
    while (found.defects.all() > 0 && result_.relaxations < relaxations && !is_endless(found)) {
      monitor.progress(static_cast<double>(result_.relaxations) / relaxations);
      add_particles(found);
      if (relaxation_centres_.empty()) break;
      relax(monitor);
      found = find_defects();
    }
    for (int round = 0; round < options_.rounds && found.defects.all() > 0 && !is_endless(found); ++round) {
      monitor.check();
      const std::size_t defects = found.defects.all();
      const std::size_t added = add_particles(found);
      ++result_.rounds;
      if (added == 0 && !converges_) break;
      if (added <= defects / 8 && converges_) closer_ *= 0.5;
      if (added == 0) continue;
      found = find_defects();
    }
    cut_pinches(found);
  }

  // More particles than any surface needs, because each box of the proof holds a single disc, and more defects than a
  // cure leaves on its way.
  void set_ends(const Findings& found) {
    constexpr std::size_t few = 1000;
    std::size_t boxes = 0;
    topology_.boxes->for_each([&boxes](const SurfaceBox&) { ++boxes; });
    const std::size_t usual = options_.usual_particles > 0 ? options_.usual_particles : particles_.size();
    most_particles_ = few + 2 * usual + (converges_ ? 8 : 1) * boxes;
    most_defects_ = few + 2 * found.defects.all();
  }

  // Whether adding more is in vain.
  bool is_endless(const Findings& found) const {
    const int patience = converges_ ? 8 : 2;  // checks
    return particles_.size() > most_particles_ ||
           (found.defects.all() > most_defects_ && checks_without_progress_ >= patience);
  }

  // Where particles were far too few, the number of defects per particle grows for some checks, until the particles
  // show the whole surface; then it falls. Without an end to come, only the least number ever counts.
  void note_progress(const Findings& found) {
    const double per_particle =
        static_cast<double>(found.defects.all()) / static_cast<double>(std::max<std::size_t>(particles_.size(), 1));
    ++checks_without_progress_;
    if (per_particle < per_particle_) checks_without_progress_ = 0;
    if (per_particle < per_particle_ || converges_) per_particle_ = per_particle;
  }

  // Compares the mesh with F = c, and returns the small places of each component that differs.
  std::vector<std::vector<Eigen::Vector3d>> compare(Findings& found) {
    std::vector<std::vector<Eigen::Vector3d>> places = small_places(differing_components());
    found.defects.differing = places.size();
    result_.differs_near.clear();
    for (const auto& of_component : places) result_.differs_near.push_back(of_component.front());
    return places;
  }

  std::vector<char> differing_components() const {
    const TriangleMesh mesh{particles_.points, delaunay_.triangles(), {}, {}};
    const std::vector<Shown> shown = match_components(mesh, sized_.surface(), topology_).shown;
    std::vector<char> differing(shown.size());
    std::transform(shown.begin(), shown.end(), differing.begin(),
                   [](Shown is) { return is == Shown::right || is == Shown::left_out ? 0 : 1; });
    return differing;
  }

  // For each of these components, points on F = c in its smallest boxes: where tunnels and bridges are decided. At
  // least one, the middle of a box where no projection ends.
  std::vector<std::vector<Eigen::Vector3d>> small_places(const std::vector<char>& components) const {
    constexpr std::size_t most = 256;  // for each component
    std::vector<std::vector<SurfaceBox>> boxes(components.size());
    topology_.boxes->for_each([&](const SurfaceBox& box) {
      if (components[box.component] != 0) boxes[box.component].push_back(box);
    });
    std::vector<std::vector<Eigen::Vector3d>> places;
    for (std::vector<SurfaceBox>& of : boxes) {
      if (of.empty()) continue;
      std::stable_sort(of.begin(), of.end(), [](const auto& a, const auto& b) { return a.depth > b.depth; });
      if (of.size() > most) of.resize(most);
      std::vector<Eigen::Vector3d> feet;
      for (const SurfaceBox& box : of) {
        const auto foot = sized_.surface().project(0.5 * (box.box.low + box.box.high));
        if (foot) feet.push_back(*foot);
      }
      if (feet.empty()) feet.emplace_back(0.5 * (of.front().box.low + of.front().box.high));
      places.push_back(std::move(feet));
    }
    return places;
  }

  void check_all_next() {
    unchecked_.resize(particles_.size());
    std::iota(unchecked_.begin(), unchecked_.end(), 0U);
  }

  // Changes the label of the nearest cell at each pinch that adding particles has not removed. Two pinches often share
  // that cell, and its label ends as it was; the particles of the next comparison, or cut_last_pinches(), mend those.
  void cut_pinches(Findings& found) {
    std::size_t before = std::numeric_limits<std::size_t>::max();
    for (int cut = 0; cut < most_cuts && !found.pinched.empty() && found.pinched.size() < before; ++cut) {
      before = found.pinched.size();
      std::size_t flipped = 0;
      for (const std::uint32_t point : found.pinched) flipped += delaunay_.flip_label_at(point) ? 1 : 0;
      result_.flipped += flipped;
      if (flipped == 0) break;
      check_all_next();
      found = find_defects();
    }
  }

  // Cuts the pinches that are left in the end one after the other, each at a cell whose other label makes them fewer.
  // All these cuts are undone if a component then differs that did not. Where many pinches are left, the cure has
  // failed for another reason.
  void cut_last_pinches(Findings& found) {
    constexpr std::size_t most_pinches = 100;
    if (found.pinched.empty() || found.pinched.size() > most_pinches) return;
    const Findings before = found;
    const std::vector<Eigen::Vector3d> differed_near = result_.differs_near;
    std::vector<Cut> cuts;
    for (int round = 0; round < most_cuts && !found.pinched.empty(); ++round) {
      const std::size_t done = cuts.size();
      for (const std::uint32_t point : found.pinched) {
        const auto cut = best_cut(point);
        if (!cut) continue;
        delaunay_.flip_label_at(cut->point, cut->rank);
        cuts.push_back(*cut);
      }
      if (cuts.size() == done) break;
      check_all_next();
      found = find_defects();
    }
    compare(found);
    if (found.defects.differing <= before.defects.differing && found.pinched.size() < before.pinched.size()) {
      result_.flipped += cuts.size();
      return;
    }
    for (const Cut& cut : cuts) delaunay_.flip_label_at(cut.point, cut.rank);
    found = before;
    result_.differs_near = differed_near;
  }

  // The nearest cell whose other label leaves fewer pinches among its corners; nothing if none of the nearest does, or
  // if the cut at another pinch has mended this one.
  std::optional<Cut> best_cut(std::uint32_t point) {
    if (count_pinches(std::array{point}) == 0) return {};
    constexpr std::size_t most_cells = 16;
    for (std::size_t rank = 0; rank < most_cells; ++rank) {
      const auto corners = delaunay_.flip_label_at(point, rank);
      if (!corners) break;
      const std::size_t after = count_pinches(*corners);
      delaunay_.flip_label_at(point, rank);
      if (after < count_pinches(*corners)) return Cut{point, rank};
    }
    return {};
  }

  // How many of these points, ascending, are pinched.
  std::size_t count_pinches(std::span<const std::uint32_t> points) const {
    const std::vector<Facet> facets = delaunay_.facets_at({points.begin(), points.end()});
    const FacetFans fans(facets, particles_.size());
    return static_cast<std::size_t>(std::count_if(points.begin(), points.end(), [&](std::uint32_t point) {
      return !fans.facets_at(point).empty() && !fans.is_closed_fan(point);
    }));
  }

  // Checks the facets at the unchecked particles. All other facets had no defect in the check before, and have not
  // changed since.
  Findings find_defects() {
    facets_ = unchecked_.size() == particles_.size() ? delaunay_.facets() : delaunay_.facets_at(unchecked_);
    const FacetFans fans(facets_, particles_.size());
    std::vector<char> defective(facets_.size(), 0);
    std::vector<char> crossed(facets_.size(), 0);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, facets_.size(), 1024), [&](const auto& range) {
      for (std::size_t n = range.begin(); n < range.end(); ++n) {
        defective[n] = is_tilted(facets_[n], particles_) ? 1 : 0;
        crossed[n] = count_crossings(facets_[n], sized_.surface()) > 1 ? 1 : 0;
      }
    });
    std::vector<char> pinched(unchecked_.size(), 0);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, unchecked_.size(), 1024), [&](const auto& range) {
      for (std::size_t n = range.begin(); n < range.end(); ++n) {
        const std::uint32_t point = unchecked_[n];
        pinched[n] = !fans.facets_at(point).empty() && !fans.is_closed_fan(point) ? 1 : 0;
      }
    });

    Findings found;
    found.defects.tilted = static_cast<std::size_t>(std::count(defective.begin(), defective.end(), 1));
    found.defects.crossed = static_cast<std::size_t>(std::count(crossed.begin(), crossed.end(), 1));
    for (std::size_t n = 0; n < unchecked_.size(); ++n) {
      const std::uint32_t point = unchecked_[n];
      has_facet_[point] = fans.facets_at(point).empty() ? 0 : 1;
      if (has_facet_[point] == 0) found.isolated.push_back(point);
      if (pinched[n] == 0) continue;
      found.pinched.push_back(point);
      for (const std::uint32_t facet : fans.facets_at(point)) defective[facet] = 1;
    }
    found.defects.pinched = found.pinched.size();
    found.defects.isolated = found.isolated.size();
    for (std::uint32_t n = 0; n < facets_.size(); ++n) {
      if (defective[n] != 0 || crossed[n] != 0) found.facets.push_back(n);
    }
    lost_ = lost_components_.find(component_, has_facet_);
    found.defects.lost = lost_.size();
    note_progress(found);

    unchecked_ = found.isolated;
    for (const std::uint32_t n : found.facets)
      unchecked_.insert(unchecked_.end(), facets_[n].corners.begin(), facets_[n].corners.end());
    return found;
  }

  bool is_near(const Eigen::Vector3d& x, std::uint32_t particle, double gap) const {
    return (particles_.points[particle] - x).norm() <= gap * particles_.spacing[particle];
  }

  // Queues x unless a particle is already there; another facet or a later round may propose it again. The search for
  // the nearest particle starts at particle `near`.
  void propose(const Eigen::Vector3d& x, std::uint32_t near) {
    if (!is_near(x, delaunay_.nearest(x, near), closer_ * least_gap_to_all)) proposed_.push_back(x);
  }

  // Adds particles for all findings and returns how many. The centres of the next relaxation are the new particles and
  // the defects at which no particle has room.
  std::size_t add_particles(const Findings& found) {
    proposed_.clear();
    relaxation_centres_.clear();
    for (const std::uint32_t n : found.facets) {
      const std::size_t before = proposed_.size();
      propose_crossings(facets_[n]);
      if (proposed_.size() == before) relaxation_centres_.push_back(centre_on_surface(facets_[n]));
    }
    for (const std::uint32_t n : found.isolated) {
      const std::size_t before = proposed_.size();
      propose_ring_around(n);
      if (proposed_.size() == before) relaxation_centres_.push_back(particles_.points[n]);
    }
    for (const auto& component : lost_) {
      for (const Eigen::Vector3d& x : component) {
        const auto foot = sized_.surface().project(x);
        if (foot) propose(*foot, 0);
      }
    }
    return insert_proposals();
  }

  // Adds the proposed particles, which become centres of the next relaxation, too, and returns how many.
  std::size_t insert_proposals() {
    const Particles added = make_particles(sized_, thinned_proposals());
    exchange({{}, added});
    relaxation_centres_.insert(relaxation_centres_.end(), added.points.begin(), added.points.end());
    result_.inserted += added.size();
    return added.size();
  }

  void relax(Monitor& monitor) {
    const Exchange relaxed =
        relax_around(relaxation_centres_, sized_, particles_, options_.least_h, options_.population, monitor);
    exchange(relaxed);
    result_.relaxed += relaxed.added.size();
    ++result_.relaxations;
  }

  // Exchanges particles, here and in the triangulation, and marks the particles whose facets may have changed.
  void exchange(const Exchange& exchanged) {
    std::vector<char> is_removed(particles_.size(), 0);
    for (const std::uint32_t n : exchanged.removed) is_removed[n] = 1;
    const Particles added = without_doubles(exchanged.added, is_removed);
    std::vector<std::uint32_t> new_index(particles_.size());
    std::transform_exclusive_scan(is_removed.begin(), is_removed.end(), new_index.begin(), 0U, std::plus<>(),
                                  [](char removed) { return removed != 0 ? 0U : 1U; });
    particles_.erase(is_removed);
    erase_marked(component_, is_removed);
    erase_marked(has_facet_, is_removed);
    for (std::size_t n = 0; n < added.size(); ++n) particles_.add(added, n);
    const std::vector<std::uint32_t> added_components = components_at(topology_, added.points);
    component_.insert(component_.end(), added_components.begin(), added_components.end());
    has_facet_.resize(particles_.size(), 1);

    std::erase_if(unchecked_, [&](std::uint32_t n) { return is_removed[n] != 0; });
    for (std::uint32_t& n : unchecked_) n = new_index[n];
    const std::vector<std::uint32_t> changed = delaunay_.replace(exchanged.removed, added.points);
    unchecked_.insert(unchecked_.end(), changed.begin(), changed.end());
    std::sort(unchecked_.begin(), unchecked_.end());
    unchecked_.erase(std::unique(unchecked_.begin(), unchecked_.end()), unchecked_.end());
  }

  // The particles that lie where no other one lies or stays: a triangulation cannot have two at one place. Projections
  // may end at the same point where the derivatives are not those of the values.
  Particles without_doubles(const Particles& added, const std::vector<char>& is_removed) const {
    const auto less = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
      return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
    };
    std::set<Eigen::Vector3d, decltype(less)> places(less);
    Particles result;
    std::uint32_t near = 0;
    for (std::size_t n = 0; n < added.size(); ++n) {
      near = delaunay_.nearest(added.points[n], near);
      const bool is_taken = is_removed[near] == 0 && particles_.points[near] == added.points[n];
      if (!is_taken && places.insert(added.points[n]).second) result.add(added, n);
    }
    return result;
  }

  // Proposes the points where a facet's dual edge crosses the surface.
  void propose_crossings(const Facet& facet) {
    for (const Eigen::Vector3d& x : crossing_points(facet, sized_.surface())) {
      const bool is_near_corner = std::any_of(facet.corners.begin(), facet.corners.end(), [&](std::uint32_t corner) {
        return is_near(x, corner, closer_ * least_gap);
      });
      if (!is_near_corner) propose(x, facet.corners[0]);
    }
  }

  Eigen::Vector3d centre_on_surface(const Facet& facet) const {
    const auto& [a, b, c] = facet.corners;
    const Eigen::Vector3d mean = (particles_.points[a] + particles_.points[b] + particles_.points[c]) / 3.0;
    return sized_.surface().project(mean).value_or(particles_.points[a]);
  }

  // Proposes a ring around a particle without a facet, so that the cells at the particle become smaller than the sheet
  // is thick.
  void propose_ring_around(std::uint32_t n) {
    const Eigen::Vector3d& normal = particles_.normals[n];
    const Eigen::Vector3d u = normal.unitOrthogonal();
    const Eigen::Vector3d v = normal.cross(u);
    constexpr int corners = 6;
    for (int corner = 0; corner < corners; ++corner) {
      const double angle = 2.0 * M_PI * corner / corners;
      const Eigen::Vector3d out = std::cos(angle) * u + std::sin(angle) * v;
      const auto foot = sized_.surface().project(particles_.points[n] + 0.5 * particles_.spacing[n] * out);
      if (foot && !is_near(*foot, n, closer_ * least_gap)) propose(*foot, n);
    }
  }

  // The proposed points, without those within least_gap times the spacing of one already kept.
  std::vector<Eigen::Vector3d> thinned_proposals() const {
    std::vector<double> reach(proposed_.size());
    for (std::size_t n = 0; n < proposed_.size(); ++n) reach[n] = closer_ * least_gap * sized_.spacing(proposed_[n]);
    const NeighbourLists near = find_neighbours(proposed_, reach);
    std::vector<char> kept(proposed_.size(), 0);
    std::vector<Eigen::Vector3d> result;
    for (std::size_t n = 0; n < proposed_.size(); ++n) {
      const auto others = near.of(n);
      kept[n] = std::none_of(others.begin(), others.end(), [&](std::uint32_t m) { return m < n && kept[m] != 0; });
      if (kept[n] != 0) result.push_back(proposed_[n]);
    }
    return result;
  }

  SizedSurface& sized_;
  const CureOptions options_;
  // Adding particles helps in the end, unless derivatives are not those of the values: then defects may remain at any
  // density, and their number would grow from round to round.
  const bool converges_;
  const CertifiedTopology& topology_;
  Particles& particles_;
  LabelledDelaunay& delaunay_;
  std::vector<std::uint32_t> component_;  // of each particle
  std::vector<char> has_facet_;           // of each particle
  std::vector<std::uint32_t> unchecked_;  // particles whose facets find_defects() has to check
  std::vector<Facet> facets_;             // the facets that find_defects() has checked last
  LostComponents lost_components_;
  std::vector<std::vector<Eigen::Vector3d>> lost_;  // points on each lost component
  std::vector<Eigen::Vector3d> proposed_;
  std::vector<Eigen::Vector3d> relaxation_centres_;
  double closer_ = 1.0;  // factor on the gaps that new particles keep; they may be closer where too few had room
  std::size_t most_particles_ = 0;
  std::size_t most_defects_ = 0;
  double per_particle_ = std::numeric_limits<double>::infinity();  // defects, in the check before or least
  int checks_without_progress_ = 0;
  CureResult result_;
};

}  // namespace

CureResult cure(SizedSurface& sized, const CertifiedTopology& topology, Particles& particles,
                LabelledDelaunay& delaunay, const CureOptions& options, Monitor& monitor) {
  return Curing(sized, topology, particles, delaunay, options).run(monitor);
}

}  // namespace isobench::particles
