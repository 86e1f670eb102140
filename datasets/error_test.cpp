#include "datasets/error.h"

#include <gtest/gtest.h>

namespace isobench {
namespace {

const std::vector<std::string> kMethods{"flying-edges", "marching-cubes", "particles", "particles-2007"};

TEST(Errors, PlacesAreShortenedWhereAPartIsUnknown) {
  EXPECT_EQ(to_string(Place{"a.toml", 3, 8}), "a.toml:3:8: ");
  EXPECT_EQ(to_string(Place{"a.toml", 3, 0}), "a.toml:3: ");
  EXPECT_EQ(to_string(Place{"a.toml", 0, 8}), "a.toml: ");
  EXPECT_EQ(to_string(Place{}), "");
}

TEST(Errors, UsageErrorsStartWithTheirPlace) {
  EXPECT_STREQ(UsageError(Place{"a.toml", 1, 2}, "wrong").what(), "a.toml:1:2: wrong");
  EXPECT_STREQ(UsageError("wrong").what(), "wrong");
}

TEST(Errors, CancellingIsNotMistakenForBadDataOrUsage) {
  try {
    throw Cancelled();
  } catch (const UsageError&) {
    FAIL();
  } catch (const DataError&) {
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "cancelled");
  }
}

TEST(NearestName, ForgivesSlips) {
  EXPECT_EQ(nearest_name("marching-cube", kMethods), "marching-cubes");
  EXPECT_EQ(nearest_name("partciles", kMethods), "particles");
  EXPECT_EQ(nearest_name("flying_edges", kMethods), "flying-edges");
}

TEST(NearestName, TakesABeginningForTheWord) { EXPECT_EQ(nearest_name("march", kMethods), "marching-cubes"); }

TEST(NearestName, DoesNotTakeAnotherWord) {
  EXPECT_EQ(nearest_name("tetrahedra", kMethods), "");
  EXPECT_EQ(nearest_name("anything", {}), "");
}

TEST(Suggestion, NamesTheNearestOrElseAll) {
  EXPECT_EQ(suggestion("particle", kMethods), "; did you mean 'particles'?");
  EXPECT_EQ(suggestion("xyz", {"a", "bcdefgh"}), "; known are: a, bcdefgh");
}

}  // namespace
}  // namespace isobench
