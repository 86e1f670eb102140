#include "isobench/foundation/error.h"

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

TEST(Printable, LeavesWordsOfAnyLanguageAsTheyAre) {
  for (const char* text : {"", "plain", "7 × 6 µm, ε ≤ ½", "日本語", "🙂", "a\\b"}) EXPECT_EQ(printable(text), text);
}

TEST(Printable, EscapesWhatTerminalsAndJsonCannotTake) {
  EXPECT_EQ(printable("a\nb\x1b[31m\x7f"), "a\\x0ab\\x1b[31m\\x7f");
  EXPECT_EQ(printable(std::string("\0", 1)), "\\x00");
  EXPECT_EQ(printable("\xff\xc3"), "\\xff\\xc3");
  EXPECT_EQ(printable("\xc2\x9b"), "\\xc2\\x9b");                    // a control character of its own
  EXPECT_EQ(printable("\xc0\xaf"), "\\xc0\\xaf");                    // an overlong form of "/"
  EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80");           // half a surrogate pair
  EXPECT_EQ(printable("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80");  // beyond Unicode
  EXPECT_STREQ(DataError("two\nlines").what(), "two\\x0alines");
}

TEST(Printable, KeepsBothEndsOfWhatIsLong) {
  const std::string text = "begin" + std::string(1000000, 'x') + "end";
  const std::string shown = printable(text);
  EXPECT_LT(shown.size(), 1100U);
  EXPECT_TRUE(shown.starts_with("begin") && shown.ends_with("end")) << shown;
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
