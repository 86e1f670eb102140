// Files as people have them, from the file to the mesh: each gives a ball of the right size in the right place, or one
// sentence that says what to do. Most kinds are behind reports of users of this and other programs.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>

#include "isobench/datasets/manifests/file_surface.h"
#include "isobench/foundation/error.h"
#include "isobench/foundation/testing/test_files.h"
#include "isobench/foundation/testing/test_folder.h"
#include "isobench/methods/lattice/marching_cubes.h"
#include "isobench/methods/mesh/mesh_facts.h"
#include "isobench/methods/mesh_files/mesh_files.h"
#include "isobench/methods/mesh_files/mesh_notes.h"

namespace isobench {
namespace {

// A ball in a lattice of 28 × 26 × 24 nodes. `steps` has the steps from node to node as columns, mm.
struct Ball {
  Eigen::Matrix3d steps = Eigen::Matrix3d::Identity();
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  double radius = 9.0;

  static constexpr std::array<int, 3> size = {28, 26, 24};
  Eigen::Vector3d middle() const { return first + steps * Eigen::Vector3d(13.5, 12.5, 11.5); }
  double depth(int i, int j, int k) const {
    return radius - (first + steps * Eigen::Vector3d(i, j, k) - middle()).norm();
  }
};

template <class T>
std::string bytes_of(const Ball& ball, const std::function<double(double)>& value) {
  std::string bytes;
  for (int k = 0; k < Ball::size[2]; ++k) {
    for (int j = 0; j < Ball::size[1]; ++j) {
      for (int i = 0; i < Ball::size[0]; ++i) bytes += bytes_of_value(static_cast<T>(value(ball.depth(i, j, k))));
    }
  }
  return bytes;
}

std::string floats_of(const Ball& ball) {
  return bytes_of<float>(ball, [](double depth) { return depth; });
}

std::string nrrd(const std::string& type, const std::string& fields, const std::string& data) {
  return fmt::format("NRRD0004\ntype: {}\ndimension: 3\nsizes: 28 26 24\nendian: little\n{}\n", type, fields) + data;
}

// A NIfTI-1 header of one file, with an sform, a qform without rotation, or both.
struct Nifti {
  std::int16_t type = 16;
  std::int16_t bits = 32;
  std::int16_t sform = 1;
  std::int16_t qform = 0;
  char units = 2;
  std::vector<std::int16_t> more = {};  // dimensions beyond the third
  bool no_sform_rows = false;
  double sform_scale = 1.0;

  std::string bytes(const Ball& ball) const {
    std::string header(352, '\0');
    const auto put = [&](std::size_t at, auto value) { header.replace(at, sizeof value, bytes_of_value(value)); };
    put(0, std::int32_t{348});
    put(40, static_cast<std::int16_t>(3 + more.size()));
    for (std::size_t n = 0; n < 7; ++n) {
      const int extra = n - 3 < more.size() ? more[n - 3] : 1;
      put(42 + 2 * n, static_cast<std::int16_t>(n < 3 ? Ball::size[n] : extra));
    }
    put(70, type);
    put(72, bits);
    put(76, 1.0F);
    for (int axis = 0; axis < 3; ++axis)
      put(80 + 4 * static_cast<std::size_t>(axis), static_cast<float>(ball.steps.col(axis).norm()));
    put(108, 352.0F);
    header[123] = units;
    put(252, qform);
    put(254, sform);
    for (int row = 0; row < 3; ++row) {
      const auto at = 280 + 16 * static_cast<std::size_t>(row);
      put(268 + 4 * static_cast<std::size_t>(row), static_cast<float>(ball.first[row]));
      if (no_sform_rows) continue;
      for (int column = 0; column < 3; ++column)
        put(at + 4 * static_cast<std::size_t>(column), static_cast<float>(sform_scale * ball.steps(row, column)));
      put(at + 12, static_cast<float>(ball.first[row]));
    }
    header.replace(344, 4, std::string("n+1\0", 4));
    return header;
  }
};

class Inputs : public testing::Test {
 protected:
  TriangleMesh mesh_of_file(const std::string& name, const FileSurface& asked) {
    const Dataset dataset = dataset_from_file(folder_.path() / name, asked, monitor_);
    return to_world(marching_cubes(*dataset.surface, monitor_), dataset.surface->lattice());
  }
  // The smooth function loses some of a ball, about the square of the voxel over the radius, and chords lose some more.
  void expect_ball(const std::string& name, const std::string& bytes, const FileSurface& asked, const Ball& ball) {
    SCOPED_TRACE(name);
    folder_.write(name, bytes);
    const TriangleMesh mesh = mesh_of_file(name, asked);
    const MeshFacts facts = mesh_facts(mesh);
    EXPECT_EQ(facts.euler, 2);
    const double volume = 4.0 / 3.0 * M_PI * std::pow(ball.radius, 3);
    EXPECT_NEAR(facts.volume / volume, 0.985, 0.0125);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& x : mesh.vertices) sum += x;
    EXPECT_LT((sum / static_cast<double>(mesh.vertices.size()) - ball.middle()).norm(), 0.02 * ball.radius);
  }
  void expect_refusal(const std::string& name, const std::string& bytes, const FileSurface& asked,
                      const std::string& part) {
    const auto path = folder_.write(name, bytes);
    try {
      dataset_from_file(path, asked, monitor_);
      ADD_FAILURE() << name << " was read; expected: " << part;
    } catch (const DataError& error) {
      const std::string message = error.what();
      EXPECT_TRUE(message.starts_with(path.string())) << message;
      EXPECT_NE(message.find(part), std::string::npos) << message;
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    }
  }
  void expect_note(const std::string& part) const {
    EXPECT_TRUE(std::any_of(monitor_.notes().begin(), monitor_.notes().end(), [&](const std::string& note) {
      return note.find(part) != std::string::npos;
    })) << part;
  }

  TestFolder folder_;
  Monitor monitor_;
};

const FileSurface at_zero = {.isovalue = 0.0};

TEST_F(Inputs, NiftiIsPlacedByTheFormThatIsGood) {
  Ball ball;
  ball.steps *= 0.5;
  ball.first = {-10.0, -9.0, 20.0};
  ball.radius = 4.5;
  const std::string data = floats_of(ball);
  expect_ball("sform.nii", Nifti().bytes(ball) + data, at_zero, ball);
  expect_ball("qform.nii", Nifti{.sform = 0, .qform = 1}.bytes(ball) + data, at_zero, ball);
  expect_ball("zero-sform.nii", Nifti{.qform = 1, .no_sform_rows = true}.bytes(ball) + data, at_zero, ball);
  expect_note("the qform is taken");
  expect_ball("conflict.nii", Nifti{.qform = 1, .sform_scale = 2.0}.bytes(ball) + data, at_zero, ball);
  expect_note("its sform states voxels of 1 × 1 × 1 mm");
  Ball unplaced = ball;
  unplaced.first.setZero();
  expect_ball("none.nii", Nifti{.sform = 0}.bytes(ball) + data, at_zero, unplaced);
}

TEST_F(Inputs, SeriesAreReadByTheStep) {
  const Ball ball;
  const std::string data = floats_of(ball);
  expect_ball("one-step.nii", Nifti{.more = {1}}.bytes(ball) + data, at_zero, ball);
  expect_ball("dim4-zero.nii", Nifti{.more = {0}}.bytes(ball) + data, at_zero, ball);
  const std::string nifti = Nifti{.more = {3}}.bytes(ball) + std::string(data.size(), '\0') + data + data;
  expect_refusal("three.nii", nifti, at_zero, "it has 3 steps; choose one with --step 0 to 2");
  expect_ball("three.nii", nifti, {.isovalue = 0.0, .part = {.step = 1}}, ball);
  expect_refusal("three.nii", nifti, {.isovalue = 0.0, .part = {.step = 3}}, "there is no step 3");
  const std::string series =
      "NRRD0004\ntype: float\ndimension: 4\nsizes: 28 26 24 2\nkinds: domain domain domain time\nendian: little\n"
      "encoding: raw\n\n" +
      data + data;
  expect_refusal("two.nrrd", series, at_zero, "choose one with --step 0 to 1");
  expect_ball("two.nrrd", series, {.isovalue = 0.0, .part = {.step = 1}}, ball);
}

TEST_F(Inputs, LengthsAreInMillimetres) {
  Ball ball;  // in mm
  ball.steps *= 0.012;
  ball.first = {0.1, 0.2, 0.3};
  ball.radius = 0.108;
  Ball microns = ball;
  microns.steps *= 1e3;
  microns.first *= 1e3;
  const std::string data = floats_of(ball);
  expect_ball("um.nii", Nifti{.units = 3}.bytes(microns) + data, at_zero, ball);
  const std::string directions = "space directions: (12,0,0) (0,12,0) (0,0,12)\nspace origin: (100,200,300)\n";
  for (const char* unit : {"um", "µm", "μm", "micrometer", "microns"}) {
    const std::string fields =
        fmt::format("encoding: raw\nspace dimension: 3\nspace units: \"{0}\" \"{0}\" \"{0}\"\n{1}", unit, directions);
    expect_ball("space.nrrd", nrrd("float", fields, data), at_zero, ball);
  }
  Ball centred = ball;
  centred.first.setZero();
  expect_ball("units.nrrd", nrrd("float", "encoding: raw\nspacings: 12 12 12\nunits: \"um\" \"um\" \"um\"\n", data),
              at_zero, centred);
  expect_ball("cm.nrrd",
              nrrd("float", "encoding: raw\nspacings: .0012 .0012 .0012\nunits: \"cm\" \"cm\" \"cm\"\n", data), at_zero,
              centred);
  expect_ball("mins.nrrd", nrrd("float", "encoding: raw\nspacings: .012 .012 .012\naxis mins: .1 .2 .3\n", data),
              at_zero, ball);
}

TEST_F(Inputs, TiltedSlicesAreSampledOnPerpendicularAxes) {
  for (const double shear : {std::tan(10.0 * M_PI / 180.0), 2e-3, -5e-4}) {
    Ball ball;
    ball.steps(2, 2) = 1.3;
    ball.steps(1, 2) = 1.3 * shear;
    ball.first = {-24.0, -20.0, 5.0};
    expect_ball("tilted.nii", Nifti().bytes(ball) + floats_of(ball), at_zero, ball);
  }
  expect_note("10° from perpendicular");
}

TEST_F(Inputs, WhatIsNotFiniteIsOutside) {
  const Ball ball;
  const FileSurface asked = {.isovalue = 100.0};
  for (const double outside : {std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::infinity()}) {
    const auto masked = [&](double depth) { return depth < -4.0 ? outside : 100.0 + 10.0 * depth; };
    expect_ball("masked.nii", Nifti().bytes(ball) + bytes_of<float>(ball, masked), asked, ball);
    expect_ball("masked.nrrd", nrrd("double", "encoding: raw\n", bytes_of<double>(ball, masked)), asked, ball);
  }
  const auto infinite = [](double depth) { return depth > 4.0 ? std::numeric_limits<double>::infinity() : depth; };
  expect_refusal("core.nii", Nifti().bytes(ball) + bytes_of<float>(ball, infinite), at_zero, "is inf");
}

TEST_F(Inputs, ValuesOfEveryMagnitudeKeepTheirDifferences) {
  const Ball ball;
  const auto expect = [&](const std::string& name, const Nifti& nifti, const std::string& data, double isovalue) {
    expect_ball(name, nifti.bytes(ball) + data, {.isovalue = isovalue}, ball);
  };
  for (const double factor : {1e-40, 1e-12, 1e30})
    expect(fmt::format("times-{:g}.nii", factor), {}, bytes_of<float>(ball, [&](double d) { return factor * d; }), 0.0);
  const auto saturated = [](double d) { return std::clamp(32768.0 + 12000.0 * d, 0.0, 65535.0); };
  expect("saturated.nii", {.type = 512, .bits = 16}, bytes_of<std::uint16_t>(ball, saturated), 32768.0);
  for (const double pedestal : {1e7, 1e9})
    expect("pedestal.nii", {.type = 64, .bits = 64}, bytes_of<double>(ball, [&](double d) { return pedestal + d; }),
           pedestal);
  const auto lifted = [](double d) { return 1e9 + std::round(10.0 * d); };
  expect("int32.nii", {.type = 8, .bits = 32}, bytes_of<std::int32_t>(ball, lifted), 1e9);
  expect("int64.nii", {.type = 1024, .bits = 64}, bytes_of<std::int64_t>(ball, lifted), 1e9);
}

TEST_F(Inputs, LabelsAreComparedAsTheIntegersThatTheyAre) {
  const Ball ball;
  const auto labels = [](double depth) { return depth > 0.0 ? 312782546.0 : 312782574.0; };
  const std::string data = bytes_of<std::uint32_t>(ball, labels);
  folder_.write("atlas.nrrd", nrrd("unsigned int", "encoding: gzip\n", deflated(data, true)));
  const TriangleMesh mesh = mesh_of_file("atlas.nrrd", {.labels = {312782546}, .smooth_voxels = 0.0});
  EXPECT_NEAR(mesh_facts(mesh).volume, 3054.0, 0.05 * 3054.0);
  EXPECT_EQ(mesh_facts(mesh).euler, 2);
}

TEST_F(Inputs, CompressedDataBeginWhereTheHeaderSays) {
  const Ball ball;
  const std::string data = floats_of(ball);
  const std::string packed = deflated(data, true);
  expect_ball("lines.nrrd", nrrd("float", "encoding: gzip\nline skip: 2\n", "one\ntwo\n" + packed), at_zero, ball);
  folder_.write("v.nii.gz", deflated(Nifti().bytes(ball) + data, true));
  expect_ball("v.nhdr", nrrd("float", "encoding: gzip\nbyte skip: -1\ndata file: v.nii.gz\n", ""), at_zero, ball);
  expect_ball("w.nhdr", nrrd("float", "encoding: gzip\nbyte skip: 352\ndata file: v.nii.gz\n", ""), at_zero, ball);
  expect_refusal("x.nhdr", nrrd("float", "encoding: gzip\ndata file: v.nii.gz\n", ""), at_zero, "352 bytes longer");
}

// A VTK image with these data arrays at its points and its cells, as text.
std::string vtk_image(const Ball& ball, const std::string& at_points, const std::string& at_cells) {
  const int more = at_cells.empty() ? 0 : 1;  // points than voxels
  const std::string extent = fmt::format("5 {} 0 {} 0 {}", 32 + more, 25 + more, 23 + more);
  const Eigen::Vector3d steps = ball.steps.diagonal();
  const Eigen::Vector3d origin = ball.first - 0.5 * more * steps - 5.0 * steps[0] * Eigen::Vector3d::UnitX();
  return fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
      "<ImageData WholeExtent=\"{0}\" Origin=\"{1} {2} {3}\" Spacing=\"{4} {5} {6}\">\n<Piece Extent=\"{0}\">\n"
      "<PointData>{7}</PointData>\n<CellData>{8}</CellData>\n</Piece>\n</ImageData>\n</VTKFile>\n",
      extent, origin[0], origin[1], origin[2], steps[0], steps[1], steps[2], at_points, at_cells);
}

std::string vtk_array(const Ball& ball, const std::string& name, int components,
                      const std::function<double(double)>& value) {
  std::string numbers;
  for (int k = 0; k < Ball::size[2]; ++k) {
    for (int j = 0; j < Ball::size[1]; ++j) {
      for (int i = 0; i < Ball::size[0]; ++i) {
        for (int n = 0; n < components; ++n) numbers += fmt::format("{:.5g} ", value(ball.depth(i, j, k)));
      }
    }
  }
  return fmt::format(
      "<DataArray type=\"Float64\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"ascii\">{}</DataArray>", name,
      components, numbers);
}

TEST_F(Inputs, VtkImagesHaveArraysByNameAndVoxelsAsCells) {
  Ball ball;
  ball.steps(2, 2) = 1.2;
  ball.first = {3.0, 4.0, 5.0};
  const std::string ct = vtk_array(ball, "ct", 1, [](double depth) { return depth; });
  const std::string labels = vtk_array(ball, "labels", 1, [](double depth) { return depth > 0.0 ? 7.0 : 0.0; });
  const std::string gradient = vtk_array(ball, "gradient", 3, [](double) { return 1.0; });
  expect_ball("points.vti", vtk_image(ball, ct, ""), at_zero, ball);
  expect_ball("cells.vti", vtk_image(ball, "", ct), at_zero, ball);
  expect_ball("vector-first.vti", vtk_image(ball, gradient + ct, ""), at_zero, ball);
  expect_note("'ct' (at points) is taken");
  expect_refusal("two.vti", vtk_image(ball, labels + ct, ""), at_zero, "choose one with --array");
  expect_ball("two.vti", vtk_image(ball, labels + ct, ""), {.isovalue = 0.0, .part = {.array = "ct"}}, ball);
  expect_ball("two.vti", vtk_image(ball, labels + ct, ""), {.isovalue = 3.5, .part = {.array = "labels"}}, ball);
  expect_refusal("two.vti", vtk_image(ball, labels + ct, ""), {.isovalue = 0.0, .part = {.array = "mr"}}, "'mr'");
}

// Ten voxels of a bar are inside the volume's border, and half a voxel more at each end.
TEST_F(Inputs, ObjectsThatLeaveTheVolumeAreClosedOutside) {
  std::string data;
  for (int k = 0; k < 10; ++k) {
    for (int j = 0; j < 24; ++j) {
      for (int i = 0; i < 24; ++i)
        data += static_cast<char>(std::clamp(100 + 40 * (8 - std::hypot(i - 11.5, j - 11.5)), 0.0, 120.0));
    }
  }
  folder_.write("bar.nrrd",
                "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 24 24 10\nspacings: 1 1 5\nencoding: raw\n\n" + data);
  const TriangleMesh mesh = mesh_of_file("bar.nrrd", {.isovalue = 100.0});
  const auto [low, high] = std::minmax_element(mesh.vertices.begin(), mesh.vertices.end(),
                                               [](const auto& a, const auto& b) { return a[2] < b[2]; });
  EXPECT_GE((*high)[2] - (*low)[2], 45.0);
  EXPECT_LE((*high)[2] - (*low)[2], 50.0);
  EXPECT_EQ(mesh_facts(mesh).euler, 2);
  expect_note("closed, outside");
  folder_.write("full.nrrd", "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 24 24 10\nencoding: raw\n\n" +
                                 std::string(std::size_t{24} * 24 * 10, '\x01'));
  EXPECT_NEAR(mesh_facts(mesh_of_file("full.nrrd", {.isovalue = 0.5})).volume, 24.0 * 24.0 * 10.0, 150.0);
}

TEST_F(Inputs, PlacesFarAwayKeepTheirShape) {
  for (const double far : {1e4, 1e5, 1e6, 1e7}) {
    Ball ball;
    ball.steps *= 0.5;
    ball.radius = 4.5;
    ball.first = {far, -far, far};
    const std::string fields = fmt::format(
        "encoding: raw\nspace: left-posterior-superior\nspace directions: (.5,0,0) (0,.5,0) (0,0,.5)\n"
        "space origin: ({0},-{0},{0})\n",
        far);
    expect_ball("far.nrrd", nrrd("float", fields, floats_of(ball)), at_zero, ball);
    const TriangleMesh mesh = mesh_of_file("far.nrrd", at_zero);
    write_mesh(mesh, folder_.path() / "far.ply");
    EXPECT_EQ(read_mesh(folder_.path() / "far.ply").vertices, mesh.vertices);
    write_mesh(mesh, folder_.path() / "far.stl");
    EXPECT_EQ(loss_in_file(mesh, folder_.path() / "far.stl").empty(), far < 1e6) << far;
  }
}

// Each slice counts with its thickness, also where the volume has only one: the same surface as with empty slices
// around.
TEST_F(Inputs, AFewSlicesAreASlab) {
  std::string slice;
  for (int j = 0; j < 40; ++j) {
    for (int i = 0; i < 40; ++i) slice += std::hypot(i - 19.5, j - 19.5) < 10.0 ? '\x01' : '\0';
  }
  const auto volume_of_file = [&](int slices, const std::string& data) {
    folder_.write(
        "slices.nrrd",
        fmt::format("NRRD0004\ntype: uchar\ndimension: 3\nsizes: 40 40 {}\nspacings: 1 1 5\nencoding: raw\n\n{}",
                    slices, data));
    const MeshFacts facts = mesh_facts(mesh_of_file("slices.nrrd", {.isovalue = 0.5}));
    EXPECT_EQ(facts.euler, 2) << slices;
    return facts.volume;
  };
  std::string data;
  const std::string empty(std::size_t{3} * 40 * 40, '\0');
  for (int slices = 1; slices <= 4; ++slices) {
    data += slice;
    std::string padded = empty;
    padded += data;
    padded += empty;
    EXPECT_NEAR(volume_of_file(slices, data), volume_of_file(slices + 6, padded), 1e-6) << slices;
  }
}

}  // namespace
}  // namespace isobench
