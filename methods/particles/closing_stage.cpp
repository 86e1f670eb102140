#include "isobench/methods/particles/closing_stage.h"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "isobench/methods/closing/labelled_delaunay.h"
#include "isobench/methods/closing/tight_cocone.h"
#include "isobench/methods/particles/cure/cure.h"
#include "isobench/methods/particles/sampling_stages.h"
#include "isobench/methods/particles/sizing_stage.h"

namespace isobench::particles {

namespace {

void record_defects(const Defects& defects, const std::string& when, Monitor& monitor) {
  monitor.set("cure/pinched " + when, static_cast<double>(defects.pinched));
  monitor.set("cure/isolated " + when, static_cast<double>(defects.isolated));
  monitor.set("cure/tilted " + when, static_cast<double>(defects.tilted));
  monitor.set("cure/crossed " + when, static_cast<double>(defects.crossed));
  monitor.set("cure/lost components " + when, static_cast<double>(defects.lost));
  monitor.set("cure/differing components " + when, static_cast<double>(defects.differing));
}

std::string difference_text(const std::vector<Eigen::Vector3d>& places, const Isosurface& surface) {
  const Eigen::Vector3d at = surface.lattice().to_world(places.front());
  return fmt::format("the mesh differs from {} component{} of F = c, near ({:.4g}, {:.4g}, {:.4g}) mm{}", places.size(),
                     places.size() == 1 ? "" : "s", at[0], at[1], at[2], places.size() == 1 ? "" : " for example");
}

std::vector<Triangle> close_by_labels(const MeshingTask& task, SizedSurface& sized, Particles& particles,
                                      Monitor& monitor) {
  drop_doubles(particles);
  LabelledDelaunay delaunay(particles.points, task.surface, monitor);
  CureOptions options;
  options.relaxations = task.parameters.integer("cure_relaxations");
  options.rounds = task.parameters.integer("cure");
  options.least_h = critical_floor(task);
  options.population = population_limits(task);
  if (options.rounds > 0) {
    const auto stage = monitor.stage("cure");
    const CureResult cured = cure(sized, task.topology(monitor), particles, delaunay, options, monitor);
    record_defects(cured.before, "before", monitor);
    record_defects(cured.after, "after", monitor);
    monitor.set("cure/rounds", cured.rounds);
    monitor.set("cure/inserted", static_cast<double>(cured.inserted));
    monitor.set("cure/relaxations", cured.relaxations);
    monitor.set("cure/relaxed", static_cast<double>(cured.relaxed));
    monitor.set("cure/labels changed", static_cast<double>(cured.flipped));
    if (!cured.differs_near.empty()) monitor.note(difference_text(cured.differs_near, task.surface));
  }
  return delaunay.triangles();
}

std::vector<Triangle> close_by_cocone(const MeshingTask& task, const Particles& particles, Monitor& monitor) {
  const bool from_poles = task.parameters.text("normals") == "poles";
  TightCocone closed =
      from_poles ? tight_cocone(particles.points, monitor) : tight_cocone(particles.points, particles.normals, monitor);
  monitor.set("cocone/undersampled", static_cast<double>(closed.undersampled));
  monitor.set("cocone/pruned", static_cast<double>(closed.pruned));
  monitor.set("cocone/bad", static_cast<double>(closed.bad));
  monitor.set("cocone/conflicts", static_cast<double>(closed.conflicts));
  monitor.set("cocone/transparent", static_cast<double>(closed.transparent));
  return std::move(closed.triangles);
}

}  // namespace

TriangleMesh close_particles(const MeshingTask& task, SizedSurface& sized, Particles particles, Monitor& monitor) {
  TriangleMesh result;
  if (task.parameters.text("surface") == "tight-cocone") {
    result.triangles = close_by_cocone(task, particles, monitor);
  } else {
    result.triangles = close_by_labels(task, sized, particles, monitor);
  }
  result.vertices = std::move(particles.points);
  monitor.set("particles/unused", static_cast<double>(drop_unused_vertices(result)));
  return result;
}

}  // namespace isobench::particles
