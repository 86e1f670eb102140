// MRC and CCP4 maps: every sample keeps its place, in ångström as the file states it.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "isobench/datasets/formats/testing/mrc_files.h"
#include "isobench/datasets/formats/testing/note_files.h"
#include "isobench/foundation/testing/test_folder.h"

namespace isobench {
namespace {

class MrcPlacement : public testing::Test {
 protected:
  std::filesystem::path write(const MrcFileHeader& header) {
    return folder_.write("a.mrc", header.bytes() + bytes_of_samples<float>(samples()));
  }
  /// The lattice of a file that says nothing but its unit.
  Lattice lattice_of(const MrcFileHeader& header) {
    return volume_with_note(write(header), "lengths are in mm from here on, and 1 Å is 1e-7 mm").lattice;
  }
  /// The lattice of a file that says this first.
  Lattice lattice_with_note(const MrcFileHeader& header, const std::string& part) {
    const VolumeFile file = read_volume(write(header));
    EXPECT_EQ(file.notes.size(), 2U);
    EXPECT_NE(file.notes[0].find(part), std::string::npos) << file.notes[0];
    return file.volume.lattice;
  }

 private:
  TestFolder folder_;
};

/// Å from node (i, j, k) of the lattice.
Eigen::Vector3d place(const Lattice& lattice, double i, double j, double k) {
  return 1e7 * lattice.to_world(lattice.spacing.cwiseProduct(Eigen::Vector3d(i, j, k)));
}

void expect_at(const Eigen::Vector3d& found, const Eigen::Vector3d& expected) {
  EXPECT_LT((found - expected).norm(), 1e-4) << found.transpose() << "; expected: " << expected.transpose();
}

TEST_F(MrcPlacement, PerpendicularAxes) {
  const Lattice lattice = lattice_of(MrcFileHeader());
  EXPECT_EQ(lattice.direction, Eigen::Matrix3d::Identity());
  EXPECT_EQ(lattice.space, "");
  expect_at(place(lattice, 0, 0, 0), Eigen::Vector3d::Zero());
  expect_at(place(lattice, 2, 3, 4), spacing.cwiseProduct(Eigen::Vector3d(2, 3, 4)));
  EXPECT_NEAR(lattice.spacing[1], 1.25e-7, 1e-13);
  // Old programs leave angles and axes 0.
  const MrcFileHeader old = MrcFileHeader().put_three(52, 0.0F, 0.0F, 0.0F).put_three(64, 0, 0, 0);
  expect_at(place(lattice_of(old), 2, 3, 4), spacing.cwiseProduct(Eigen::Vector3d(2, 3, 4)));
}

TEST_F(MrcPlacement, ColumnsRowsAndSectionsAlongOtherAxes) {
  // Columns along Z, rows along X, sections along Y; the first ones are 5, -2 and 1.
  const MrcFileHeader header = MrcFileHeader().put_three(64, 3, 1, 2).put_three(16, 5, -2, 1);
  const Lattice lattice = lattice_of(header);
  for (const Eigen::Vector3i& node : {Eigen::Vector3i(0, 0, 0), Eigen::Vector3i(6, 0, 0), Eigen::Vector3i(1, 4, 3)}) {
    const Eigen::Vector3d expected((node[1] - 2) * spacing[0], (node[2] + 1) * spacing[1], (node[0] + 5) * spacing[2]);
    expect_at(place(lattice, node[0], node[1], node[2]), expected);
  }
  EXPECT_EQ(lattice.size, (std::array<int, 3>{nx, ny, nz}));
}

TEST_F(MrcPlacement, CellsThatAreNotRectangular) {
  const double pi = std::numbers::pi;
  const Eigen::Vector3d angles(80.0, 105.0, 120.0);
  const MrcFileHeader header = MrcFileHeader().put_three(52, 80.0F, 105.0F, 120.0F);
  const Lattice lattice = lattice_of(header);
  EXPECT_LT((lattice.spacing * 1e7 - spacing).norm(), 1e-5);
  const auto& axes = lattice.direction;
  EXPECT_NEAR(axes.col(1).dot(axes.col(2)), std::cos(angles[0] * pi / 180.0), 1e-6);
  EXPECT_NEAR(axes.col(2).dot(axes.col(0)), std::cos(angles[1] * pi / 180.0), 1e-6);
  EXPECT_NEAR(axes.col(0).dot(axes.col(1)), std::cos(angles[2] * pi / 180.0), 1e-6);
  EXPECT_EQ(axes.col(0), Eigen::Vector3d::UnitX());
  EXPECT_EQ(axes(2, 1), 0.0);
  EXPECT_GT(axes(2, 2), 0.0);
  // NXSTART follows the skew axes, too.
  MrcFileHeader moved = header;
  moved.put_three(16, 0, 4, 0);
  expect_at(place(lattice_of(moved), 0, 0, 0), 4.0 * spacing[1] * axes.col(1));
}

TEST_F(MrcPlacement, CellsThatCannotBe) {
  const float not_a_number = std::numeric_limits<float>::quiet_NaN();
  for (const std::array<float, 3>& angles : {std::array<float, 3>{90.0F, 90.0F, 180.0F},
                                             {90.0F, 90.0F, -10.0F},
                                             {10.0F, 90.0F, 20.0F},
                                             {90.0F, 0.0F, 90.0F},
                                             {not_a_number, 90.0F, 90.0F},
                                             {90.0F, 90.0F, 1e30F}}) {
    expect_data_error(write(MrcFileHeader().put_three(52, angles[0], angles[1], angles[2])), "no cell has the angles");
  }
  expect_data_error(write(MrcFileHeader().put(60, 2.0F)), "nearly in a plane");
}

TEST_F(MrcPlacement, TheOriginAndTheFirstColumn) {
  const Eigen::Vector3d shift(10.0, -20.0, 30.5);
  const auto with_origin = [&] { return MrcFileHeader().put_three(196, 10.0F, -20.0F, 30.5F); };
  expect_at(place(lattice_of(with_origin()), 0, 0, 0), shift);
  // Columns -1, rows 2, sections 3: at (-0.5, 2.5, 9) Å.
  expect_at(place(lattice_of(MrcFileHeader().put_three(16, -1, 2, 3)), 0, 0, 0), Eigen::Vector3d(-0.5, 2.5, 9.0));
  const MrcFileHeader both = with_origin().put_three(16, -1, 2, 3);
  expect_at(place(lattice_with_note(both, "ORIGIN is taken"), 0, 0, 0), shift);
  const MrcFileHeader same = MrcFileHeader().put_three(16, -1, 2, 3).put_three(196, -0.5F, 2.5F, 9.0F);
  expect_at(place(lattice_of(same), 0, 0, 0), Eigen::Vector3d(-0.5, 2.5, 9.0));
  // IMOD had the other sign, unless it says that it has not.
  expect_at(place(lattice_of(with_origin().make_old().mark_as_imod(1)), 0, 0, 0), -shift);
  expect_at(place(lattice_of(with_origin().make_old().mark_as_imod(4)), 0, 0, 0), shift);
  expect_at(place(lattice_of(with_origin().mark_as_imod(1)), 0, 0, 0), shift);
  expect_at(place(lattice_of(with_origin().make_old()), 0, 0, 0), shift);
  expect_data_error(write(MrcFileHeader().put(196, std::numeric_limits<float>::infinity())), "origin");
}

TEST_F(MrcPlacement, SizesThatAreMissing) {
  const MrcFileHeader no_intervals = MrcFileHeader().put_three(28, 0, 0, 0).put_three(40, 7.0F, 12.0F, 15.0F);
  const Lattice by_size = lattice_with_note(no_intervals, "how many intervals its cell has");
  EXPECT_LT((by_size.spacing * 1e7 - Eigen::Vector3d(1.0, 2.0, 3.0)).norm(), 1e-5);
  const Lattice unknown =
      lattice_with_note(MrcFileHeader().put_three(40, 0.0F, 0.0F, 0.0F), "does not state the size of its voxels; 1 Å");
  EXPECT_LT((unknown.spacing * 1e7 - Eigen::Vector3d::Ones()).norm(), 1e-9);
  const Lattice image = lattice_with_note(MrcFileHeader().put(48, 0.0F), "along every axis; 0.5 Å is taken there");
  EXPECT_LT((image.spacing * 1e7 - Eigen::Vector3d(0.5, 1.25, 0.5)).norm(), 1e-5);
}

}  // namespace
}  // namespace isobench
