// `isobench mesh` on a user's volume file, anisotropic and oblique: the mesh lies where the volume's file says, in mm.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "isobench/experiments/command_line/test_program.h"
#include "isobench/foundation/testing/test_files.h"
#include "isobench/foundation/testing/test_folder.h"
#include "isobench/methods/mesh/mesh_facts.h"
#include "isobench/methods/mesh_files/mesh_files.h"

namespace isobench {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// The object in world coordinates: an ellipsoid whose axes are neither those of the world nor those of the lattice.
const Vector3d semi_axes(9.0, 6.5, 4.5);
const Vector3d centre(37.0, -21.5, 12.25);
Matrix3d pose() { return Eigen::AngleAxisd(0.9, Vector3d(-1.0, 1.0, 2.0).normalized()).toRotationMatrix(); }

/// q = 1 − |x|² in units of the semi-axes: 0 on the ellipsoid. Its Hessian is −2 M.
Matrix3d shape_matrix() { return pose() * semi_axes.cwiseAbs2().cwiseInverse().asDiagonal() * pose().transpose(); }

/// Samples 300 ± 200 q on a lattice around the object.
struct Scan {
  std::array<int, 3> size{};
  Vector3d spacing{0.8, 1.1, 1.7};
  Matrix3d direction;
  Vector3d origin;
  std::vector<float> samples;

  explicit Scan(Matrix3d axes, double sign = 1.0) : direction(std::move(axes)) {
    const double reach = semi_axes.maxCoeff() + 6.0;
    for (std::size_t a = 0; a < 3; ++a) {
      size[a] = static_cast<int>(std::ceil(2.0 * reach / spacing[static_cast<int>(a)])) + 1;
    }
    origin = centre - direction * Vector3d(reach + 0.1, reach + 0.2, reach + 0.3);
    for (int k = 0; k < size[2]; ++k) {
      for (int j = 0; j < size[1]; ++j) {
        for (int i = 0; i < size[0]; ++i) {
          const Vector3d x = origin + direction * spacing.cwiseProduct(Vector3d(i, j, k)) - centre;
          samples.push_back(static_cast<float>(300.0 + sign * 200.0 * (1.0 - x.dot(shape_matrix() * x))));
        }
      }
    }
  }
  /// The isovalue at which F is exactly the ellipsoid after smoothing by a kernel of these variances (mm², along the
  /// lattice's axes): smoothing adds the constant −Σ v M to a quadratic function.
  double isovalue(const Vector3d& variances, double sign = 1.0) const {
    const Matrix3d m = direction.transpose() * shape_matrix() * direction;
    return 300.0 - sign * 200.0 * variances.dot(m.diagonal());
  }
  /// Variances of the cubic B-spline kernel.
  Vector3d spline_variances() const { return spacing.cwiseAbs2() / 3.0; }
};

Matrix3d oblique_axes() { return Eigen::AngleAxisd(0.6, Vector3d(1.0, 2.0, 3.0).normalized()).toRotationMatrix(); }

std::string row_text(const Vector3d& v, const char* between) {
  return fmt::format("{1:.17g}{0}{2:.17g}{0}{3:.17g}", between, v[0], v[1], v[2]);
}

std::string nrrd(const Scan& s) {
  std::string directions;
  for (int axis = 0; axis < 3; ++axis) {
    directions += fmt::format(" ({})", row_text(s.spacing[axis] * s.direction.col(axis), ","));
  }
  return fmt::format(
             "NRRD0004\ntype: float\ndimension: 3\nspace: left-posterior-superior\nsizes: {} {} {}\nspace "
             "directions:{}\nspace origin: ({})\nendian: little\nencoding: gzip\n\n",
             s.size[0], s.size[1], s.size[2], directions, row_text(s.origin, ",")) +
         deflated(bytes_of_samples<float>(s.samples), true);
}

std::string metaimage(const Scan& s) {
  const Matrix3d& d = s.direction;
  return fmt::format(
             "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\nDimSize = {} {} "
             "{}\nElementSpacing = {}\nOffset = {}\nTransformMatrix = {} {} {}\nElementType = "
             "MET_FLOAT\nElementDataFile = LOCAL\n",
             s.size[0], s.size[1], s.size[2], row_text(s.spacing, " "), row_text(s.origin, " "),
             row_text(d.col(0), " "), row_text(d.col(1), " "), row_text(d.col(2), " ")) +
         bytes_of_samples<float>(s.samples);
}

/// NIfTI-1 with an sform, gzipped; offsets and codes as the format states them.
std::string nifti(const Scan& s) {
  std::string header(352, '\0');
  const auto put = [&header](std::size_t at, auto value) { header.replace(at, sizeof(value), bytes_of_value(value)); };
  put(0, std::int32_t{348});
  put(40, std::int16_t{3});
  for (std::size_t a = 0; a < 3; ++a) {
    put(42 + 2 * a, static_cast<std::int16_t>(s.size[a]));
    put(80 + 4 * a, static_cast<float>(s.spacing[static_cast<int>(a)]));
  }
  for (std::size_t a = 3; a < 7; ++a) put(42 + 2 * a, std::int16_t{1});
  put(70, std::int16_t{16});  // float
  put(72, std::int16_t{32});
  put(76, 1.0F);
  put(108, 352.0F);  // where the samples start
  header[123] = 2;   // mm
  put(254, std::int16_t{1});
  for (int row = 0; row < 3; ++row) {
    const std::size_t at = 280 + 16 * static_cast<std::size_t>(row);
    for (int axis = 0; axis < 3; ++axis) {
      put(at + 4 * static_cast<std::size_t>(axis), static_cast<float>(s.direction(row, axis) * s.spacing[axis]));
    }
    put(at + 12, static_cast<float>(s.origin[row]));
  }
  header.replace(344, 4, std::string("n+1\0", 4));
  return deflated(header + bytes_of_samples<float>(s.samples), true);
}

std::string vti(const Scan& s) {
  const Matrix3d& d = s.direction;
  std::string text = fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\">\n<ImageData "
      "WholeExtent=\"0 {0} 0 {1} 0 {2}\" Origin=\"{3}\" Spacing=\"{4}\" Direction=\"{5} {6} {7}\">\n<Piece Extent=\"0 "
      "{0} 0 {1} 0 {2}\"><PointData Scalars=\"v\"><DataArray type=\"Float32\" Name=\"v\" format=\"ascii\">\n",
      s.size[0] - 1, s.size[1] - 1, s.size[2] - 1, row_text(s.origin, " "), row_text(s.spacing, " "),
      row_text(d.row(0), " "), row_text(d.row(1), " "), row_text(d.row(2), " "));
  for (const float sample : s.samples) text += fmt::format("{}\n", sample);
  return text + "</DataArray></PointData></Piece></ImageData></VTKFile>\n";
}

/// Half the sides of the object's bounding box in the world.
Vector3d half_box() { return (pose() * semi_axes.asDiagonal()).rowwise().norm(); }

constexpr double edge = 0.8;  // mm

/// Expects each vertex within `off` mm of the ellipsoid, and box and volume of the mesh to be the ellipsoid's.
void expect_the_ellipsoid(const TriangleMesh& mesh, double off) {
  ASSERT_GT(mesh.vertices.size(), 200U);
  Vector3d low = mesh.vertices[0];
  Vector3d high = low;
  double farthest = 0.0;
  for (const Vector3d& x : mesh.vertices) {
    const Vector3d u = (pose().transpose() * (x - centre)).cwiseQuotient(semi_axes);
    // To first order |q|/|∇q|, the distance to the ellipsoid.
    farthest = std::max(farthest, std::abs(1.0 - u.squaredNorm()) / (2.0 * u.cwiseQuotient(semi_axes).norm()));
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  EXPECT_LT(farthest, off);
  // The outermost vertex may lie half an edge beside the ellipsoid's extreme point. With the smallest radius of
  // curvature there, 4.5²/9 mm, the ellipsoid lies 0.04 mm lower at that vertex.
  const double fallen = 0.25 * edge * edge / 2.0 / (semi_axes[2] * semi_axes[2] / semi_axes[0]);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(low[axis], centre[axis] - half_box()[axis] + 0.5 * fallen, 0.5 * fallen + off) << axis;
    EXPECT_NEAR(high[axis], centre[axis] + half_box()[axis] - 0.5 * fallen, 0.5 * fallen + off) << axis;
  }
  const MeshFacts facts = mesh_facts(mesh);
  EXPECT_EQ(facts.open_edges, 0U);
  EXPECT_EQ(facts.euler, 2);
  // Equilateral triangles of edge h, inscribed, lie below the surface by h²/8 times the mean curvature on average. So a
  // ball's mesh lacks 3h²/(8R²) of its volume; an ellipsoid's lacks a little more.
  const double volume = 4.0 / 3.0 * std::numbers::pi * semi_axes.prod();
  const double inscribed = 3.0 / 8.0 * edge * edge * std::pow(semi_axes.prod(), -2.0 / 3.0);
  EXPECT_NEAR(facts.volume / volume, 1.0 - inscribed, 0.3 * inscribed + 2.0 * off / semi_axes[2]);
}

void expect_meshed(const TestFolder& folder, const std::string& scan, double isovalue, const std::string& mesh,
                   const std::vector<std::string>& more, double off) {
  SCOPED_TRACE(scan + " to " + mesh);
  std::vector<std::string> arguments = {
      "mesh", "--volume", scan, "--isovalue", fmt::format("{}", isovalue), "--edge-length", fmt::format("{}", edge),
      "-o",   mesh,       "-q"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Outcome outcome = run_program(folder.path(), arguments);
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  expect_the_ellipsoid(read_mesh(folder.path() / mesh), off);
}

TEST(OwnFile, GoesToEveryMeshFormatInItsPlace) {
  const TestFolder folder;
  const Scan scan(oblique_axes());
  folder.write("scan.nrrd", nrrd(scan));
  folder.write("scan.mha", metaimage(scan));
  folder.write("scan.nii.gz", nifti(scan));
  folder.write("scan.vti", vti(scan));
  const double isovalue = scan.isovalue(scan.spline_variances());
  for (const char* volume : {"scan.nrrd", "scan.mha", "scan.nii.gz", "scan.vti"}) {
    for (const char* mesh : {"a.stl", "a.ply", "a.off", "a.obj", "a.vtp"}) {
      // Single precision stores samples of up to 2000 with errors of 1e-4, and F changes by at least 45 per mm.
      expect_meshed(folder, volume, isovalue, mesh, {}, 2e-5);
    }
  }
}

TEST(OwnFile, MayBeDarkSmoothedAndMirrored) {
  const TestFolder folder;
  Matrix3d mirrored = oblique_axes();
  mirrored.col(1) = -mirrored.col(1);
  const Scan scan(mirrored, -1.0);
  folder.write("scan.nii.gz", nifti(scan));
  folder.write("scan.mha", metaimage(scan));
  const Vector3d gaussian = scan.spacing.cwiseAbs2();  // a sigma of one voxel
  const double isovalue = scan.isovalue(scan.spline_variances() + gaussian, -1.0);
  // The sampled Gaussian is cut off at four sigma, where it lacks 1e-3 of its variance.
  for (const char* volume : {"scan.nii.gz", "scan.mha"}) {
    expect_meshed(folder, volume, isovalue, "a.stl", {"--inside", "below", "--smooth", "1"}, 1e-3);
  }
  expect_meshed(folder, "scan.mha", scan.isovalue(scan.spline_variances(), -1.0), "a.ply", {"--inside", "below"}, 2e-5);
}

}  // namespace
}  // namespace isobench
