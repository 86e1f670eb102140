#include "isobench/experiments/plan/cell_numbers.h"

#include <gtest/gtest.h>

namespace isobench {
namespace {

using Numbers = std::vector<std::size_t>;

TEST(CellNumbers, RangesAndSingleOnesInAnyOrder) {
  EXPECT_EQ(parse_cell_numbers("5", 5), (Numbers{5}));
  EXPECT_EQ(parse_cell_numbers("7,2-4,3", 9), (Numbers{2, 3, 4, 7}));
  EXPECT_EQ(cell_numbers_text({2, 3, 4, 7, 9, 10}), "2-4,7,9-10");
  EXPECT_EQ(cell_numbers_text({}), "");
  const Numbers all = parse_cell_numbers("1-100000", 100000);
  EXPECT_EQ(all.size(), 100000U);
  EXPECT_EQ(cell_numbers_text(all), "1-100000");
}

TEST(CellNumbers, SaysWhatIsWrong) {
  const auto message = [](const std::string& words) {
    try {
      parse_cell_numbers(words, 9);
    } catch (const UsageError& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  EXPECT_NE(message("3-12").find("no cell 12; the plan has cells 1 to 9"), std::string::npos) << message("3-12");
  EXPECT_NE(message("0").find("no cell 0"), std::string::npos);
  EXPECT_NE(message("5-3").find("backwards"), std::string::npos);
  for (const char* words : {"", "a", "1,", "1-", "-1", "1--2", "1 2", "1-2-3", "99999999999999999999"})
    EXPECT_NE(message(words).find("is not a cell number"), std::string::npos) << words << ": " << message(words);
}

}  // namespace
}  // namespace isobench
