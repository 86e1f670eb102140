// The real volumes, prepared as their manifests state. ISOBENCH_DATA must name the folder that has them.
#include <gtest/gtest.h>

#include <cstdlib>
#include <ostream>

#include "isobench/datasets/manifests/catalogue.h"
#include "isobench/datasets/manifests/data_files.h"

namespace isobench {
namespace {

struct Expected {
  const char* name;
  std::array<int, 3> size;
  Eigen::Vector3d spacing;
};

void PrintTo(const Expected& expected, std::ostream* out) { *out << expected.name; }

/// True if ISOBENCH_DATA has the folder, or the cache, where an earlier run may have put a Debian package's files.
bool is_at_hand(const std::string& folder) {
  const char* root = std::getenv("ISOBENCH_DATA");
  if (root == nullptr) return false;
  return std::filesystem::is_directory(std::filesystem::path(root) / folder) ||
         std::filesystem::is_directory(cache_folder() / folder);
}

class CatalogueOnVolumes : public testing::TestWithParam<Expected> {};

TEST_P(CatalogueOnVolumes, ArePreparedToTheSizeKnown) {
  const Expected& expected = GetParam();
  if (!is_at_hand(expected.name)) GTEST_SKIP() << "ISOBENCH_DATA names no folder with " << expected.name;
  Monitor monitor;
  const Dataset dataset = load_dataset(expected.name, monitor);
  EXPECT_EQ(dataset.surface->lattice().size, expected.size);
  EXPECT_LT((dataset.surface->lattice().spacing - expected.spacing).norm(), 1e-3);
  EXPECT_EQ(dataset.checksum, dataset_checksum(expected.name));
  for (const StageTime& stage : monitor.stages()) RecordProperty(stage.name, std::to_string(stage.wall_seconds));
}

// The sizes come from a separate preparation of the same data with NumPy and SciPy.
INSTANTIATE_TEST_SUITE_P(Real, CatalogueOnVolumes,
                         testing::Values(Expected{"brain", {138, 176, 146}, {1.0, 1.0, 1.0}},
                                         Expected{"pelvis", {318, 200, 236}, {1.0, 1.0, 1.0}},
                                         Expected{"skull", {256, 256, 116}, {1.0, 1.0, 2.0}},
                                         Expected{"vessel", {312, 286, 160}, {0.46875, 0.46875, 0.7}},
                                         Expected{"skull-small", {64, 64, 64}, {3.94305, 3.94305, 3.65079}},
                                         Expected{"brain-mni", {151, 188, 160}, {1.0, 1.0, 1.0}}),
                         [](const auto& test) {
                           std::string name = test.param.name;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace isobench
