// The names of the figures of a measurement, once: run.json, results.csv and the tables all go by this list.
#pragma once

#include "isobench/metrics/measurement.h"

namespace isobench {

/// Calls visit(name, value) for every figure; `Figures` is Measurement or const Measurement, so the list reads and
/// writes.
template <class Figures, class Visitor>
void visit_figures(Figures& m, Visitor&& visit) {
  visit("vertices", m.vertices);
  visit("triangles", m.triangles);
  visit("radius_ratio_min", m.radius_ratio.min);
  visit("radius_ratio_p01", m.radius_ratio.p01);
  visit("radius_ratio_avg", m.radius_ratio.avg);
  visit("angle_min", m.angles.min);
  visit("angle_max", m.angles.max);
  visit("valence_lt5_percent", m.valence.lt5_percent);
  visit("valence_5_percent", m.valence.v5_percent);
  visit("valence_6_percent", m.valence.v6_percent);
  visit("valence_7_percent", m.valence.v7_percent);
  visit("valence_gt7_percent", m.valence.gt7_percent);
  visit("valence_extreme_count", m.valence.extreme_count);
  visit("unused_vertices", m.valence.unused_vertices);
  visit("edge_over_h0_max", m.edges.over_h0_max);
  visit("edge_over_h0_mean", m.edges.over_h0_mean);
  visit("edge_over_h0_exceed_percent", m.edges.exceed_percent);
  visit("edge_over_h0_exceed_count", m.edges.exceed_count);
  visit("edge_over_h0_exceed_triangle_percent", m.edges.exceed_triangle_percent);
  visit("edge_over_own_h0_max", m.edges.over_own_h0_max);
  visit("edge_over_own_h0_exceed_percent", m.edges.own_exceed_percent);
  visit("edge_over_own_h0_exceed_triangle_percent", m.edges.own_exceed_triangle_percent);
  visit("floor_area_percent", m.edges.floor_area_percent);
  visit("components", m.topology.components);
  visit("euler", m.topology.euler);
  visit("boundary_edges", m.topology.boundary_edges);
  visit("nonmanifold_edges", m.topology.nonmanifold_edges);
  visit("misoriented_edges", m.topology.misoriented_edges);
  visit("nonmanifold_vertices", m.topology.nonmanifold_vertices);
  visit("self_intersections", m.topology.self_intersections);
  visit("reference_k", m.reference.k);
  visit("components_reference", m.reference.components);
  visit("euler_reference", m.reference.euler);
  visit("distance_mean", m.distance.mean);
  visit("distance_max", m.distance.max);
  visit("distance_vertex_max", m.distance.vertex_max);
  visit("distance_mean_voxels", m.distance.mean_voxels);
  visit("distance_max_voxels", m.distance.max_voxels);
  visit("distance_from_surface_mean", m.distance_from_surface.mean);
  visit("distance_from_surface_max", m.distance_from_surface.max);
  visit("distance_unprojected", m.distance.unprojected);
}

/// The same for the histograms.
template <class Figures, class Visitor>
void visit_histograms(Figures& m, Visitor&& visit) {
  visit("radius_ratio", m.radius_ratio.histogram);
  visit("angle", m.angles.histogram);
  visit("edge_over_h0", m.edges.histogram);
}

}  // namespace isobench
