#include "isobench/methods/lattice/marching_cubes.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <vtkImageData.h>
#include <vtkMarchingCubes.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "isobench/datasets/phantoms/phantoms.h"
#include "isobench/methods/mesh/mesh_facts.h"
#include "isobench/methods/method.h"

namespace isobench {
namespace {

TriangleMesh extract(const Isosurface& surface) {
  Monitor monitor;
  return marching_cubes(surface, monitor);
}

/// Random samples within a border of the other sign. They include every case of the table, most of them often.
FloatVolume closed_noise(const std::array<int, 3>& size, const Eigen::Vector3d& spacing = Eigen::Vector3d::Ones()) {
  std::mt19937_64 random(9);
  std::uniform_real_distribution<float> unit(-1.0F, 1.0F);
  FloatVolume v;
  v.lattice.size = size;
  v.lattice.spacing = spacing;
  v.samples.assign(v.lattice.nodes(), -1.0F);
  for (int k = 3; k < size[2] - 3; ++k) {
    for (int j = 3; j < size[1] - 3; ++j) {
      for (int i = 3; i < size[0] - 3; ++i) v.at(i, j, k) = unit(random);
    }
  }
  return v;
}

class MarchingCubesPhantom : public testing::TestWithParam<Phantom> {};

TEST_P(MarchingCubesPhantom, IsClosedOutwardAndOfTheRightTopologyAreaAndVolume) {
  const Phantom& p = GetParam();
  // The finer lattice of the thin sheets gives their rims of 1 mm as many voxels as the rims of the slab have.
  const Isosurface surface(sample_phantom(p, p.name == "thin-sheets" ? 160 : 100), 0.0);
  const MeshFacts facts = mesh_facts(extract(surface));
  EXPECT_EQ(facts.open_edges, 0U);
  EXPECT_EQ(facts.nonmanifold_edges, 0U);
  EXPECT_EQ(facts.euler, p.euler);
  EXPECT_EQ(facts.components, static_cast<std::size_t>(p.components));
  EXPECT_GT(facts.volume, 0.0);
  if (!p.area || !p.volume) return;
  // The spline moves the surface inwards by (k1 + k2) voxel²/6. This reduces the volume by voxel²/6 ∫(k1 + k2) and, by
  // Gauss and Bonnet for a constant k1 + k2, the area by voxel²/3 · 2πχ: less than 0.6 % and 0.3 % with voxels of half
  // a millimetre. Chords as long as a voxel reduce both by as much again.
  EXPECT_NEAR(facts.volume / *p.volume, 1.0, 0.008);
  EXPECT_NEAR(facts.area / *p.area, 1.0, 0.006);
}

INSTANTIATE_TEST_SUITE_P(Phantoms, MarchingCubesPhantom, testing::ValuesIn(phantoms()), [](const auto& instance) {
  std::string name = instance.param.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST(MarchingCubesTest, EveryVertexIsOnTheSurfaceAndOnALatticeEdge) {
  const Eigen::Vector3d spacing(0.7, 1.0, 1.9);
  for (const Kernel kernel : {Kernel::bspline, Kernel::catmull_rom}) {
    const Isosurface surface(closed_noise({20, 21, 22}, spacing), 0.05, Inside::above, kernel);
    for (const Eigen::Vector3d& x : extract(surface).vertices) {
      EXPECT_LT(std::abs(surface.value(x)), 1e-8);  // |∇F| is about 1/voxel, so this is in voxels
      int whole = 0;
      for (int axis = 0; axis < 3; ++axis) {
        const double u = x[axis] / spacing[axis];
        whole += std::abs(u - std::round(u)) < 1e-12;
      }
      EXPECT_GE(whole, 2) << x.transpose();
    }
  }
}

TEST(MarchingCubesTest, NoiseIsClosedWithOneVertexACrossedEdge) {
  for (const Inside inside : {Inside::above, Inside::below}) {
    // More than one word of 64 nodes in a row, and the last word is not full.
    const Isosurface surface(closed_noise({131, 17, 19}), 0.05, inside);
    const TriangleMesh mesh = extract(surface);
    const MeshFacts facts = mesh_facts(mesh);
    EXPECT_EQ(facts.open_edges, 0U);
    EXPECT_EQ(facts.volume > 0.0, inside == Inside::above);
    std::size_t crossed = 0;
    const auto& size = surface.lattice().size;
    const std::size_t row = static_cast<std::size_t>(size[0]);
    const std::size_t slab = row * static_cast<std::size_t>(size[1]);
    std::vector<float> values, values_of_slab;
    for (int k = 0; k < size[2]; ++k) {
      surface.node_values(k, values_of_slab);
      values.insert(values.end(), values_of_slab.begin(), values_of_slab.end());
    }
    for (std::size_t n = 0; n < values.size(); ++n) {
      const bool here = values[n] > 0.0F;
      if ((n + 1) % row != 0) crossed += here != (values[n + 1] > 0.0F);
      if (n % slab + row < slab) crossed += here != (values[n + row] > 0.0F);
      if (n + slab < values.size()) crossed += here != (values[n + slab] > 0.0F);
    }
    EXPECT_EQ(mesh.vertices.size(), crossed);
    std::vector<bool> used(mesh.vertices.size(), false);
    for (const Triangle& t : mesh.triangles) {
      for (const std::uint32_t corner : t) used[corner] = true;
    }
    EXPECT_EQ(std::count(used.begin(), used.end(), false), 0);
  }
}

TEST(MarchingCubesTest, CountsAreThoseOfVtkOnTheSameNodeValues) {
  for (const std::array<int, 3>& size : {std::array<int, 3>{20, 21, 22}, {70, 9, 10}}) {
    const Isosurface surface(closed_noise(size), 0.05);
    vtkNew<vtkImageData> image;
    image->SetDimensions(size[0], size[1], size[2]);
    image->AllocateScalars(VTK_FLOAT, 1);
    auto* to = static_cast<float*>(image->GetScalarPointer());
    std::vector<float> slab;
    for (int k = 0; k < size[2]; ++k) {
      surface.node_values(k, slab);
      to = std::copy(slab.begin(), slab.end(), to);
    }
    vtkNew<vtkMarchingCubes> reference;
    reference->SetInputData(image);
    reference->SetValue(0, 0.0);
    reference->Update();
    const TriangleMesh mesh = extract(surface);
    EXPECT_EQ(static_cast<vtkIdType>(mesh.vertices.size()), reference->GetOutput()->GetNumberOfPoints());
    EXPECT_EQ(static_cast<vtkIdType>(mesh.triangles.size()), reference->GetOutput()->GetNumberOfCells());
  }
}

TEST(MarchingCubesTest, TheMeshIsTheSameForAnyNumberOfThreads) {
  const Isosurface surface(sample_phantom(phantom("gyroid-ball"), 90), 0.0);
  TriangleMesh first;
  for (const std::size_t threads : {1U, 2U, 4U}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const TriangleMesh mesh = extract(surface);
    if (threads == 1U) first = mesh;
    EXPECT_TRUE(mesh.vertices == first.vertices) << threads;
    EXPECT_TRUE(mesh.triangles == first.triangles) << threads;
  }
}

TEST(MarchingCubesTest, AnObjectThatLeavesTheLatticeIsOpenThere) {
  FloatVolume v;
  v.lattice.size = {6, 7, 8};
  v.samples.resize(v.lattice.nodes());
  for (int k = 0; k < 8; ++k) {
    for (int j = 0; j < 7; ++j) {
      for (int i = 0; i < 6; ++i) v.at(i, j, k) = static_cast<float>(k) - 3.6F;
    }
  }
  const MeshFacts facts = mesh_facts(extract(Isosurface(v, 0.0)));
  EXPECT_NEAR(facts.area, 5.0 * 6.0, 1e-6);
  EXPECT_EQ(facts.open_edges, 2U * (5U + 6U));
}

TEST(MarchingCubesTest, NodesExactlyOnTheSurfaceAreOutside) {
  // f = 4 − |x| − |y| − |z| of Catmull-Rom is 0 at many nodes. Vertices coincide there, and the mesh is closed.
  FloatVolume v;
  v.lattice.size = {13, 13, 13};
  v.samples.resize(v.lattice.nodes());
  for (int k = 0; k < 13; ++k) {
    for (int j = 0; j < 13; ++j) {
      for (int i = 0; i < 13; ++i)
        v.at(i, j, k) = static_cast<float>(4 - std::abs(i - 6) - std::abs(j - 6) - std::abs(k - 6));
    }
  }
  const TriangleMesh mesh = extract(Isosurface(v, 0.0, Inside::above, Kernel::catmull_rom));
  const MeshFacts facts = mesh_facts(mesh);
  EXPECT_EQ(facts.open_edges, 0U);
  EXPECT_EQ(facts.euler, 2);
  // One vertex for each edge from f = 1 to f = 0. A node of the layer |x| + |y| + |z| = 3 with n coordinates other than
  // 0 has 6 − n such edges: 6 tips with 5, 24 nodes in the coordinate planes with 4, 8 nodes in the octants with 3.
  EXPECT_EQ(mesh.vertices.size(), 6U * 5U + 24U * 4U + 8U * 3U);
  EXPECT_EQ(mesh.vertices.front(), Eigen::Vector3d(6.0, 6.0, 2.0));
  EXPECT_NEAR(facts.volume, 4.0 / 3.0 * 64.0, 1e-9);  // the octahedron itself
}

TEST(MarchingCubesTest, StopsWhenCancelled) {
  const Isosurface surface(sample_phantom(phantom("sphere"), 32), 0.0);
  Monitor monitor;
  monitor.cancel();
  EXPECT_THROW(marching_cubes(surface, monitor), Cancelled);
}

TEST(MarchingCubesMethodTest, MeshesAndSaysThatSizingHasNoEffect) {
  const Isosurface surface(sample_phantom(phantom("torus"), 40), 0.0);
  SizingRequest request;
  request.edge_length = 3.0;
  Monitor monitor;
  const Method& m = method("marching-cubes");
  const TriangleMesh mesh = m.mesh(MeshingTask(surface, request, Parameters(m.parameters), 1), monitor);
  EXPECT_EQ(mesh.vertices, extract(surface).vertices);
  ASSERT_EQ(monitor.notes().size(), 1U);
  EXPECT_NE(monitor.notes()[0].find("no effect"), std::string::npos);
}

}  // namespace
}  // namespace isobench
