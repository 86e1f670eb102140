// If a volume is stretched, rotated and moved, its surface must be, too. The tests cover the whole way from a file of
// each format to the mesh in millimetres.

#include <gtest/gtest.h>

#include <cstring>

#include "isobench/datasets/formats/testing/oblique_files.h"
#include "isobench/datasets/isosurface.h"
#include "isobench/foundation/testing/test_folder.h"
#include "isobench/methods/lattice/marching_cubes.h"
#include "isobench/methods/mesh/mesh_facts.h"
#include "isobench/methods/method.h"

namespace isobench {
namespace {

/// The samples of oblique_files.h with a spacing of 1 mm, at the origin, along the axes of the world.
FloatVolume plain_volume() {
  FloatVolume volume;
  volume.lattice.size = {nx, ny, nz};
  volume.samples = samples();
  return volume;
}

TriangleMesh world_mesh(Volume volume) {
  const Lattice lattice = volume.lattice;
  Monitor monitor;
  return to_world(marching_cubes(Isosurface(std::move(volume), closed_isovalue), monitor), lattice);
}

/// The position of lattice coordinates u according to the file's header.
Eigen::Vector3d stated_place(const Eigen::Vector3d& u, const Eigen::Matrix3d& direction, const Eigen::Vector3d& first) {
  return first + direction * spacing.cwiseProduct(u);
}

void expect_same_surface(const std::string& format, const Volume& volume, const Eigen::Matrix3d& direction,
                         const Eigen::Vector3d& first) {
  const TriangleMesh plain = world_mesh(plain_volume());
  const TriangleMesh found = world_mesh(volume);
  ASSERT_GT(plain.triangles.size(), 50U);
  ASSERT_EQ(found.triangles, plain.triangles) << format;
  for (std::size_t v = 0; v < plain.vertices.size(); ++v) {
    // NIfTI stores its orientation in single precision, which gives errors of 1e-5 mm at 60 mm from the origin.
    ASSERT_LT((found.vertices[v] - stated_place(plain.vertices[v], direction, first)).norm(), 1e-5) << format;
  }
  // For every orientation, the enclosed volume is the plain mesh's volume times the volume of a voxel.
  EXPECT_NEAR(mesh_facts(found).volume, mesh_facts(plain).volume * spacing.prod(), 1e-4) << format;
}

std::string nifti_file() {
  NiftiHeader header;
  header.put_sform(oblique(), origin);
  return header.bytes() + bytes_of_samples<float>(samples());
}

TEST(ObliqueSurface, IsThePlainOneInPlaceForEveryFormatWithAnOrientation) {
  const TestFolder folder;
  const std::string floats = bytes_of_samples<float>(samples());
  const std::vector<std::pair<std::string, std::string>> files = {
      {"a.nrrd", nrrd_header("float", "raw") + "\n" + floats},
      {"a.mha", metaimage_header("ElementType = MET_FLOAT\nElementDataFile = LOCAL") + floats},
      {"a.nii", nifti_file()},
      {"a.vti", vti_text(text_of_samples())},
  };
  for (const auto& [name, bytes] : files) {
    expect_same_surface(name, volume_of(folder.write(name, bytes)), oblique(), origin);
  }
}

TEST(ObliqueSurface, IsThePlainOneStretchedForFormatsWithSpacingAlone) {
  const TestFolder folder;
  const std::string floats = bytes_of_samples<float>(samples());
  const auto inr = folder.write("a.inr", inrimage(inrimage_fields("TYPE=float\nPIXSIZE=32 bits", "decm"), floats));
  expect_same_surface("a.inr", volume_of(inr), Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero());
  RawLayout layout;
  layout.size = {nx, ny, nz};
  layout.spacing = spacing;
  layout.type = SampleType::f32;
  expect_same_surface("raw", read_raw({folder.write("a.raw", floats)}, layout), Eigen::Matrix3d::Identity(),
                      Eigen::Vector3d::Zero());
}

TEST(ObliqueSurface, IsMeshedByParticlesAsIfItLayStraight) {
  FloatVolume straight = plain_volume();
  straight.lattice.spacing = spacing;
  FloatVolume turned = straight;
  turned.lattice.direction = oblique();
  turned.lattice.origin = origin;
  const auto mesh = [](const FloatVolume& volume) {
    const Isosurface surface(volume, closed_isovalue);
    SizingRequest request;
    request.edge_length = 0.6;
    Monitor monitor;
    const Method& particles = method("particles");
    return particles.mesh(MeshingTask(surface, request, Parameters(particles.parameters), 1), monitor);
  };
  const TriangleMesh a = mesh(straight);
  const TriangleMesh b = mesh(turned);
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.vertices, b.vertices) << "in the lattice frame the two are one surface";
  const TriangleMesh placed = to_world(b, turned.lattice);
  EXPECT_NEAR(mesh_facts(placed).volume, mesh_facts(a).volume, 1e-9 * mesh_facts(a).volume);
  EXPECT_LT((placed.vertices[0] - (origin + oblique() * a.vertices[0])).norm(), 1e-12);
}

}  // namespace
}  // namespace isobench
