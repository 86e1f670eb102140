#include "isobench/metrics/measurement.h"

namespace isobench {

const std::vector<MetricDefinition>& metric_definitions() {
  static const std::vector<MetricDefinition> definitions{
      {"vertices", "", "Number of vertices in the mesh."},
      {"triangles", "", "Number of triangles in the mesh."},
      {"radius_ratio_min", "",
       "Smallest radius ratio Q = 2 r_in / r_circ of any triangle: twice the radius of its inscribed circle over that "
       "of "
       "its circumscribed circle, 1 for an equilateral triangle, 0 for one without area."},
      {"radius_ratio_p01", "",
       "0.1 percentile of the radius ratio by nearest rank: of n triangles the value of the ⌈n/1000⌉-th worst."},
      {"radius_ratio_avg", "", "Mean radius ratio, each triangle counting the same."},
      {"angle_min", "°", "Smallest angle of any triangle."},
      {"angle_max", "°", "Largest angle of any triangle."},
      {"valence_lt5_percent", "%",
       "Vertices with fewer than five edges, of all vertices that have a triangle; 6 is the valence of a regular "
       "mesh."},
      {"valence_5_percent", "%", "Vertices with five edges, of all vertices that have a triangle."},
      {"valence_6_percent", "%", "Vertices with six edges, of all vertices that have a triangle."},
      {"valence_7_percent", "%", "Vertices with seven edges, of all vertices that have a triangle."},
      {"valence_gt7_percent", "%", "Vertices with more than seven edges, of all vertices that have a triangle."},
      {"valence_extreme_count", "", "Number of vertices with fewer than five or more than seven edges."},
      {"edge_over_h0_max", "",
       "Largest ratio of an edge's length to the mean of h0 at its ends, where h0 = max(floor, 2ε min(λ, 1/|κ_max|)) "
       "(λ the local feature size, κ_max the larger principal curvature, no gradient limit) or, where a uniform size "
       "was "
       "asked for, the edge length asked for. Above 1 the sampling bound is missed."},
      {"edge_over_h0_mean", "", "Mean ratio of edge length to h0, each edge counting the same."},
      {"edge_over_h0_exceed_percent", "%", "Edges longer than the mean of h0 at their ends, of all edges."},
      {"edge_over_h0_exceed_count", "", "Number of edges longer than the mean of h0 at their ends."},
      {"edge_over_h0_exceed_triangle_percent", "%",
       "Triangles with at least one edge longer than the mean of h0 at its ends, of all triangles: the paper's count."},
      {"edge_over_own_h0_max", "",
       "Largest ratio of an edge's length to the mean at its ends of the h0 that the method itself computed, where it "
       "computes one by stages of its own (another medial axis, other nodes); elsewhere the same as edge_over_h0_max."},
      {"edge_over_own_h0_exceed_percent", "%",
       "Edges longer than the mean of the method's own h0 at their ends, of all edges: whether the method keeps what "
       "it "
       "set itself, not whether that was right. Elsewhere the same as edge_over_h0_exceed_percent."},
      {"edge_over_own_h0_exceed_triangle_percent", "%",
       "Triangles with at least one edge longer than the mean of the method's own h0 at its ends, of all triangles."},
      {"floor_area_percent", "%",
       "Share of the mesh's area where h0 is held up by its floor instead of following curvature and feature size; "
       "each "
       "corner stands for a third of its triangle."},
      {"components", "",
       "Connected components of the mesh: triangles that can be reached from one another over edges."},
      {"components_reference", "",
       "Connected components of the surface itself, counted without any mesh from the signs of F − c on a lattice "
       "refined reference_k times, and as finely as they need it around critical points of F, cut into Kuhn "
       "tetrahedra."},
      {"euler", "",
       "Euler characteristic χ = vertices − edges + triangles of the mesh, vertices without a triangle left out; a "
       "closed "
       "surface of genus g has 2 − 2g."},
      {"euler_reference", "",
       "Euler characteristic of the surface itself: edges − triangles + tetrahedra whose corners differ in the sign of "
       "F − c, on a lattice refined reference_k times, and as finely as they need it around critical points of F, cut "
       "into Kuhn tetrahedra; the outermost two layers of nodes count as outside."},
      {"reference_k", "",
       "How many times finer than the data's lattice the one is on which the reference was counted."},
      {"boundary_edges", "", "Edges of a single triangle; none in a closed mesh."},
      {"nonmanifold_edges", "", "Edges of three or more triangles."},
      {"misoriented_edges", "", "Edges whose two triangles run through them in the same direction."},
      {"nonmanifold_vertices", "",
       "Vertices whose triangles form more than one fan around them (pinches), the ends of non-manifold edges "
       "included."},
      {"self_intersections", "",
       "Pairs of triangles that meet elsewhere than in a vertex or an edge that they share, by exact predicates "
       "(CGAL); "
       "triangles without area are left out."},
      {"distance_mean", "mm",
       "Mean distance of the mesh to the surface F = c, weighted by area, from the corners, edge midpoints and "
       "centroid "
       "of each triangle; the distance of a point is that to the point of the surface which Newton's steps along the "
       "gradient lead to, or |F − c|/|∇F| where they do not get there."},
      {"distance_max", "mm", "Largest distance of those points to the surface F = c."},
      {"distance_vertex_max", "mm", "Largest distance of a vertex to the surface F = c."},
      {"distance_mean_voxels", "voxels",
       "Mean distance in voxels, a voxel being the geometric mean of the lattice's spacings."},
      {"distance_max_voxels", "voxels", "Largest distance in voxels."},
      {"distance_from_surface_mean", "mm",
       "Mean distance of the surface F = c to the mesh, by area: what distance_mean does not see, such as a part that "
       "the "
       "mesh misses. From the vertices of marching cubes on the data's lattice and the projected centroids of its "
       "triangles."},
      {"distance_from_surface_max", "mm", "Largest distance of those places on the surface F = c to the mesh."},
      {"distance_unprojected", "", "Points whose way to the surface did not end on it; |F − c|/|∇F| was taken there."},
  };
  return definitions;
}

}  // namespace isobench
