#include "isobench/foundation/text.h"

#include <gtest/gtest.h>

namespace isobench {
namespace {

TEST(Text, IsTrimmedAtBothEnds) {
  EXPECT_EQ(trimmed(" \t a b\r\n"), "a b");
  EXPECT_EQ(trimmed("a"), "a");
  EXPECT_EQ(trimmed(" \n"), "");
  EXPECT_EQ(trimmed(""), "");
}

TEST(Text, LosesItsCapitals) {
  EXPECT_EQ(lower_case("Scan.NII.gz"), "scan.nii.gz");
  EXPECT_EQ(lower_case("[AZ] Äß"), "[az] Äß");
}

}  // namespace
}  // namespace isobench
