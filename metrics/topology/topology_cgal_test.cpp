// The topology of generated meshes, counted by CGAL and, where CGAL has no say, by brute force.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkMarchingCubes.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <map>
#include <random>
#include <set>

#include "isobench/methods/mesh/sample_meshes.h"
#include "isobench/metrics/topology/topology.h"

namespace isobench {

namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using SurfaceMesh = CGAL::Surface_mesh<Point>;

bool is_manifold_for_cgal(const TriangleMesh& mesh) {
  const std::vector<std::array<std::size_t, 3>> triangles = [&] {
    std::vector<std::array<std::size_t, 3>> copy;
    for (const Triangle& t : mesh.triangles) copy.push_back({t[0], t[1], t[2]});
    return copy;
  }();
  return pmp::is_polygon_soup_a_polygon_mesh(triangles);
}

/// Everything that CGAL counts must be what we count; `mesh` is manifold, perhaps with boundary.
void expect_agreement(const TriangleMesh& mesh, const std::string& name) {
  SCOPED_TRACE(name);
  const TopologyFigures figures = measure_connectivity(mesh);
  ASSERT_TRUE(is_manifold_for_cgal(mesh));
  EXPECT_EQ(figures.nonmanifold_edges + figures.nonmanifold_vertices + figures.misoriented_edges, 0U);

  std::vector<Point> points;
  for (const Eigen::Vector3d& v : mesh.vertices) points.emplace_back(v.x(), v.y(), v.z());
  SurfaceMesh cgal;
  pmp::polygon_soup_to_polygon_mesh(points, mesh.triangles, cgal);
  std::size_t used = 0;
  for (const auto v : cgal.vertices()) used += cgal.is_isolated(v) ? 0 : 1;
  EXPECT_EQ(figures.euler, static_cast<long>(used) - static_cast<long>(cgal.number_of_edges()) +
                               static_cast<long>(cgal.number_of_faces()));
  std::size_t border = 0;
  for (const auto e : cgal.edges()) border += cgal.is_border(e) ? 1 : 0;
  EXPECT_EQ(figures.boundary_edges, border);
  EXPECT_EQ(figures.closed_manifold(), CGAL::is_closed(cgal));
  auto component = cgal.add_property_map<SurfaceMesh::Face_index, std::size_t>("f:component").first;
  EXPECT_EQ(figures.components, pmp::connected_components(cgal, component));
}

vtkNew<vtkImageData> smoothed_noise(int n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> noise(-1.0F, 1.0F);
  vtkNew<vtkImageData> image;
  image->SetDimensions(n, n, n);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* samples = static_cast<float*>(image->GetScalarPointer());
  const auto count = static_cast<std::size_t>(n) * static_cast<std::size_t>(n) * static_cast<std::size_t>(n);
  for (std::size_t s = 0; s < count; ++s) samples[s] = noise(random);
  for (std::size_t s = 0; s + 1 < count; ++s) samples[s] = 0.5F * (samples[s] + samples[s + 1]);
  return image;
}

template <class Filter>
TriangleMesh contour(vtkImageData* image) {
  vtkNew<Filter> filter;
  filter->SetInputData(image);
  filter->SetValue(0, 0.2);
  filter->ComputeNormalsOff();
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  TriangleMesh mesh;
  for (vtkIdType p = 0; p < output->GetNumberOfPoints(); ++p) {
    mesh.vertices.emplace_back(Eigen::Map<const Eigen::Vector3d>(output->GetPoint(p)));
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; c < output->GetPolys()->GetNumberOfCells(); ++c) {
    output->GetPolys()->GetCellAtId(c, ids);
    mesh.triangles.push_back({static_cast<std::uint32_t>(ids->GetId(0)), static_cast<std::uint32_t>(ids->GetId(1)),
                              static_cast<std::uint32_t>(ids->GetId(2))});
  }
  return mesh;
}

TEST(TopologyAgainstCgal, ManifoldMeshes) {
  using sample_meshes::together;
  expect_agreement(sample_meshes::tetrahedron(), "tetrahedron");
  expect_agreement(sample_meshes::torus(30), "torus");
  TriangleMesh punctured = together(sample_meshes::torus(30), sample_meshes::box({0, 0, 0}, {1, 1, 1}));
  punctured.triangles.erase(punctured.triangles.begin() + 40, punctured.triangles.begin() + 47);
  punctured.triangles.pop_back();
  expect_agreement(punctured, "torus and box with holes");
}

TEST(TopologyAgainstCgal, ContoursOfNoise) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    const TriangleMesh mesh = contour<vtkMarchingCubes>(smoothed_noise(24, seed));
    EXPECT_GT(mesh.triangles.size(), 10000U);
    expect_agreement(mesh, "marching cubes, seed " + std::to_string(seed));
    expect_agreement(contour<vtkFlyingEdges3D>(smoothed_noise(24, seed)), "flying edges, seed " + std::to_string(seed));
  }
}

/// Figures by maps and sets, one definition after the other.
TopologyFigures count_by_brute_force(const TriangleMesh& mesh) {
  std::map<std::set<std::uint32_t>, std::vector<std::pair<std::uint32_t, std::uint32_t>>> edges;
  std::set<std::uint32_t> used;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      used.insert(t[i]);
      edges[{t[i], t[(i + 1) % 3]}].emplace_back(t[i], t[(i + 1) % 3]);
    }
  }
  TopologyFigures figures;
  figures.euler =
      static_cast<long>(used.size()) - static_cast<long>(edges.size()) + static_cast<long>(mesh.triangles.size());
  for (const auto& [ends, sides] : edges) {
    figures.boundary_edges += sides.size() == 1 ? 1 : 0;
    figures.nonmanifold_edges += sides.size() > 2 ? 1 : 0;
    figures.misoriented_edges += sides.size() == 2 && sides[0] == sides[1] ? 1 : 0;
  }
  // A vertex is manifold if the sides opposite to it form one path or one cycle.
  for (const std::uint32_t v : used) {
    std::map<std::uint32_t, std::vector<std::uint32_t>> link;
    for (const Triangle& t : mesh.triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        if (t[i] != v) continue;
        link[t[(i + 1) % 3]].push_back(t[(i + 2) % 3]);
        link[t[(i + 2) % 3]].push_back(t[(i + 1) % 3]);
      }
    }
    std::set<std::uint32_t> reached{link.begin()->first};
    std::vector<std::uint32_t> next{link.begin()->first};
    bool branches = false;
    while (!next.empty()) {
      const std::vector<std::uint32_t> around = link[next.back()];
      next.pop_back();
      branches |= around.size() > 2;
      for (const std::uint32_t w : around) {
        if (reached.insert(w).second) next.push_back(w);
      }
    }
    figures.nonmanifold_vertices += branches || reached.size() < link.size() ? 1 : 0;
  }
  return figures;
}

TEST(TopologyAgainstCgal, RandomSoups) {
  std::mt19937 random(11);
  std::size_t pinches = 0;
  std::size_t manifold = 0;
  for (int n = 0; n < 300; ++n) {
    TriangleMesh mesh;
    mesh.vertices.resize(12, Eigen::Vector3d::Zero());
    std::set<std::set<std::uint32_t>> taken;
    const int triangles = 2 + n / 15;
    for (int t = 0; t < triangles; ++t) {
      Triangle triangle{};
      do {
        for (std::uint32_t& v : triangle) v = static_cast<std::uint32_t>(random() % 12);
      } while (std::set<std::uint32_t>(triangle.begin(), triangle.end()).size() < 3 ||
               !taken.insert({triangle.begin(), triangle.end()}).second);
      mesh.triangles.push_back(triangle);
    }
    const TopologyFigures ours = measure_connectivity(mesh);
    const TopologyFigures slow = count_by_brute_force(mesh);
    ASSERT_EQ(ours.euler, slow.euler);
    ASSERT_EQ(ours.boundary_edges, slow.boundary_edges);
    ASSERT_EQ(ours.nonmanifold_edges, slow.nonmanifold_edges);
    ASSERT_EQ(ours.misoriented_edges, slow.misoriented_edges);
    ASSERT_EQ(ours.nonmanifold_vertices, slow.nonmanifold_vertices) << "soup " << n;
    ASSERT_EQ(ours.nonmanifold_edges + ours.misoriented_edges + ours.nonmanifold_vertices == 0,
              is_manifold_for_cgal(mesh))
        << "soup " << n;
    pinches += ours.nonmanifold_vertices;
    manifold += ours.nonmanifold_edges + ours.misoriented_edges + ours.nonmanifold_vertices == 0 ? 1 : 0;
  }
  EXPECT_GT(pinches, 100U);
  EXPECT_GT(manifold, 5U);
}

}  // namespace

}  // namespace isobench
