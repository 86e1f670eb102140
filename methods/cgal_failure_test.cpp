#include "isobench/methods/cgal_failure.h"

#include <gtest/gtest.h>

namespace isobench {
namespace {

TEST(WithCgal, GivesTheResult) {
  EXPECT_EQ(with_cgal("a method", [] { return 3; }), 3);
}

TEST(WithCgal, AFailedCheckIsOneSentenceWithThePlace) {
  try {
    with_cgal("a method", [] { throw CGAL::Assertion_exception("CGAL", "", "/some/where/Refine.h", 859, "twice"); });
    FAIL() << "no error";
  } catch (const Error& error) {
    const std::string text = error.what();
    EXPECT_EQ(text.find("a method: CGAL stopped at one of its own checks (Refine.h, line 859)"), 0U) << text;
  }
}

TEST(WithCgal, OtherErrorsPass) {
  EXPECT_THROW(with_cgal("a method", [] { throw Cancelled(); }), Cancelled);
}

}  // namespace
}  // namespace isobench
