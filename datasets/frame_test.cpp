#include "isobench/datasets/frame.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "isobench/foundation/error.h"

namespace isobench {
namespace {

Lattice turned(const std::string& space) {
  Lattice lattice;
  lattice.size = {5, 6, 7};
  lattice.spacing = {1.0, 2.0, 3.0};
  lattice.origin = {10.0, -20.0, 30.0};
  lattice.direction = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1.0, 2.0, 3.0).normalized()).toRotationMatrix();
  lattice.space = space;
  return lattice;
}

TEST(Frame, LpsAndRasDifferByHalfATurn) {
  const Eigen::Vector3d place(1.0, 2.0, 3.0);
  const Lattice ras = turned("RAS");
  const Lattice lps = in_frame(ras, Frame::lps);
  EXPECT_EQ(lps.space, "LPS");
  EXPECT_EQ(lps.to_world(place), Eigen::Vector3d(-1.0, -1.0, 1.0).cwiseProduct(ras.to_world(place)));
  EXPECT_EQ(lps.right_handed(), ras.right_handed());
  EXPECT_LT((lps.to_local(lps.to_world(place)) - place).norm(), 1e-12);
  EXPECT_EQ(in_frame(lps, Frame::ras).to_world(place), ras.to_world(place));
  EXPECT_EQ(in_frame(ras, Frame::ras).to_world(place), ras.to_world(place));
  EXPECT_EQ(in_frame(ras, Frame::file).to_world(place), ras.to_world(place));
}

TEST(Frame, OfTheLatticeIsThatOfTheNodes) {
  const Lattice lattice = in_frame(turned("RAS"), Frame::lattice);
  EXPECT_EQ(lattice.to_world({1.0, 2.0, 3.0}), Eigen::Vector3d(1.0, 2.0, 3.0));
}

TEST(Frame, OfAFileThatDoesNotSayIsNeitherLpsNorRas) {
  EXPECT_THROW(in_frame(turned(""), Frame::lps), UsageError);
  EXPECT_THROW(in_frame(turned(""), Frame::ras), UsageError);
  EXPECT_NO_THROW(in_frame(turned(""), Frame::file));
}

}  // namespace
}  // namespace isobench
