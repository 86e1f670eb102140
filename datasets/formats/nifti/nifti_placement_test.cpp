// NIfTI: where a volume lies, and what is said where its header contradicts itself.
#include <gtest/gtest.h>

#include <limits>

#include "isobench/datasets/formats/testing/nifti_files.h"
#include "isobench/datasets/formats/testing/note_files.h"
#include "isobench/foundation/testing/test_folder.h"

namespace isobench {
namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
const Eigen::Matrix3d identity = Eigen::Matrix3d::Identity();
const Eigen::Vector3d elsewhere(1.0, 2.0, 3.0);

std::string placed_floats() { return bytes_of_samples<float>(samples()); }

void put_pixdim(NiftiHeader& header, const Eigen::Vector3d& voxel) {
  for (int n = 0; n < 3; ++n) header.put<float>(80 + 4 * static_cast<std::size_t>(n), static_cast<float>(voxel[n]));
}

/// Steps in place of the sform's.
void put_steps(NiftiHeader& header, const Eigen::Matrix3d& steps) {
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      header.put<float>(280 + 16 * static_cast<std::size_t>(row) + 4 * static_cast<std::size_t>(column),
                        static_cast<float>(steps(row, column)));
    }
  }
}

class NiftiPlacement : public testing::Test {
 protected:
  std::filesystem::path write(const NiftiHeader& header) {
    return folder_.write("a.nii", header.bytes() + placed_floats());
  }

 private:
  TestFolder folder_;
};

TEST_F(NiftiPlacement, FormsThatAgreeSayNothing) {
  NiftiHeader both;
  both.put_sform(oblique(), origin);
  both.put_qform(oblique(), origin);
  expect_oblique(volume_without_note(write(both)));
  // Apart by less than a tenth of a voxel, which is 0.05 mm here.
  both.put_qform(oblique(), origin + Eigen::Vector3d(0.04, 0.0, 0.0));
  expect_oblique(volume_without_note(write(both)));
  // The size of the voxels in the sform alone.
  NiftiHeader sform;
  sform.put_sform(oblique(), origin);
  put_pixdim(sform, Eigen::Vector3d::Zero());
  expect_oblique(volume_without_note(write(sform)));
}

TEST_F(NiftiPlacement, FormsThatPutTheVolumeInDifferentPlacesAreToldApart) {
  NiftiHeader shifted;
  shifted.put_sform(oblique(), origin);
  shifted.put_qform(oblique(), origin + Eigen::Vector3d(0.0, 0.06, 0.0));
  expect_oblique(volume_with_note(write(shifted), "differently, by up to 0.06 mm; the sform is taken"));
  NiftiHeader turned;
  turned.put_sform(oblique(), origin);
  turned.put_qform(identity, origin);
  expect_oblique(volume_with_note(write(turned), "its sform and its qform place it differently"));
}

TEST_F(NiftiPlacement, AnSformThatHasLostItsSpacingGivesWayToTheQform) {
  NiftiHeader header;
  header.put_qform(oblique(), origin);
  header.put_sform(oblique(), origin);
  put_steps(header, oblique());  // of length 1
  expect_oblique(volume_with_note(
      write(header),
      "its sform states voxels of 1 × 1 × 1 mm, but its pixdim and qform of 0.5 × 1.25 × 3 mm; the qform is taken"));
  put_steps(header, oblique() * (1.011 * spacing).asDiagonal());
  expect_oblique(volume_with_note(write(header), "the qform is taken"));
  // Within a hundredth, the sizes are the same, but the far end of the volume may be in another place.
  put_steps(header, oblique() * (1.009 * spacing).asDiagonal());
  const Eigen::Vector3d larger = 1.009 * spacing;
  EXPECT_LT((volume_with_note(write(header), "the sform is taken").lattice.spacing - larger).norm(), 1e-6);
  header.put<std::int16_t>(252, 0);
  EXPECT_LT((volume_without_note(write(header)).lattice.spacing - larger).norm(), 1e-6);
}

TEST_F(NiftiPlacement, WithoutAQformTheSformIsTakenAndTheOtherSizeIsSaid) {
  for (const bool damaged : {false, true}) {
    NiftiHeader header;
    header.put_sform(oblique(), origin);
    put_pixdim(header, 2.0 * spacing);
    if (damaged) {
      header.put_qform(identity, origin);
      header.put<float>(256, 7.0F);
    }
    expect_oblique(volume_with_note(write(header), "but its pixdim of 1 × 2.5 × 6 mm; the sform is taken"));
  }
}

TEST_F(NiftiPlacement, AnSformThatCannotBeUsedGivesWayToTheQform) {
  Eigen::Matrix3d flat = oblique() * spacing.asDiagonal();
  flat.col(2) = flat.col(0) + 0.001 * flat.col(2);
  Eigen::Matrix3d no_number = oblique() * spacing.asDiagonal();
  no_number(1, 1) = not_a_number;
  for (const Eigen::Matrix3d& steps : {Eigen::Matrix3d(Eigen::Matrix3d::Zero()), flat, no_number}) {
    NiftiHeader header;
    header.put_sform(oblique(), elsewhere);
    put_steps(header, steps);
    header.put_qform(oblique(), origin);
    expect_oblique(volume_with_note(write(header), "its sform is zero or damaged; the qform is taken"));
    for (const bool damaged : {false, true}) {
      header.put<std::int16_t>(252, 0);
      if (damaged) {
        header.put_qform(oblique(), origin);
        header.put<float>(256, not_a_number);
      }
      const Volume volume = volume_with_note(write(header), "the size of its voxels is taken, without a place");
      EXPECT_LT((volume.lattice.spacing - spacing).norm(), 1e-6);
      EXPECT_EQ(volume.lattice.direction, identity);
      EXPECT_EQ(volume.lattice.origin, Eigen::Vector3d::Zero());
      EXPECT_EQ(volume.lattice.space, "");
    }
  }
}

TEST_F(NiftiPlacement, ADamagedQformAloneLeavesTheSize) {
  for (const std::size_t at : {256U, 268U}) {
    for (const float wrong : {not_a_number, std::numeric_limits<float>::infinity()}) {
      NiftiHeader header;
      header.put_qform(oblique(), origin);
      header.put<float>(at, wrong);
      const Volume volume = volume_with_note(write(header), "its qform is damaged");
      EXPECT_LT((volume.lattice.spacing - spacing).norm(), 1e-6);
      EXPECT_EQ(volume.lattice.space, "");
    }
  }
  // Rounding may make the stored part of the quaternion a little longer than 1.
  NiftiHeader half_turn;
  half_turn.put_qform(identity, origin);
  half_turn.put<float>(256, 1.0001F);
  const Volume volume = volume_without_note(write(half_turn));
  EXPECT_LT((volume.lattice.direction - Eigen::Matrix3d(Eigen::Vector3d(1.0, -1.0, -1.0).asDiagonal())).norm(), 1e-6);
}

TEST_F(NiftiPlacement, ANegativeOrMissingSize) {
  NiftiHeader header;
  put_pixdim(header, Eigen::Vector3d(-0.5, 1.25, 3.0));
  const Volume volume = volume_with_note(write(header), "negative size");
  EXPECT_LT((volume.lattice.spacing - spacing).norm(), 1e-6);
  header.put_qform(oblique(), origin);  // tells where right and left are
  expect_oblique(volume_without_note(write(header)));
  for (const float wrong : {0.0F, not_a_number, std::numeric_limits<float>::infinity()}) {
    NiftiHeader none;
    none.put<float>(84, wrong);
    expect_data_error(write(none), "axis 1: its spacing");
  }
}

TEST_F(NiftiPlacement, AShearedSformIsKept) {
  Eigen::Matrix3d steps = oblique() * spacing.asDiagonal();
  steps.col(2) += 0.17 * spacing[2] * oblique().col(1);  // a gantry tilted by 10°
  NiftiHeader header;
  header.put_sform(oblique(), origin);
  put_steps(header, steps);
  put_pixdim(header, steps.colwise().norm());
  const Lattice lattice = volume_without_note(write(header)).lattice;
  EXPECT_LT((lattice.direction * lattice.spacing.asDiagonal() - steps).norm(), 1e-5);
  EXPECT_LT((lattice.origin - origin).norm(), 1e-5);
}

TEST_F(NiftiPlacement, UnitsOfLength) {
  const std::pair<int, double> units[] = {{0, 1.0}, {1, 1000.0}, {2, 1.0}, {3, 1e-3}, {2 | 8, 1.0}, {3 | 16, 1e-3}};
  for (const auto& [code, millimetres] : units) {
    for (const bool by_sform : {false, true}) {
      NiftiHeader header;
      if (by_sform)
        header.put_sform(oblique(), origin);
      else
        header.put_qform(oblique(), origin);
      header.put<std::uint8_t>(123, static_cast<std::uint8_t>(code));
      const Lattice lattice = volume_without_note(write(header)).lattice;
      EXPECT_LT((lattice.spacing / millimetres - spacing).norm(), 1e-5) << code;
      EXPECT_LT((lattice.origin / millimetres - origin).norm(), 1e-5) << code;
      EXPECT_LT((lattice.direction - oblique()).norm(), 1e-5) << code;
    }
  }
  NiftiHeader strange;
  strange.put_sform(oblique(), origin);
  strange.put<std::uint8_t>(123, 5);
  expect_oblique(volume_with_note(write(strange), "code 5 for the unit of length is not known; mm are taken"));
}

}  // namespace
}  // namespace isobench
