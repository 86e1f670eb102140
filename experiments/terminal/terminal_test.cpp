#include "isobench/experiments/terminal/terminal.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdlib>

namespace isobench {
namespace {

TEST(Terminal, TextIsBrokenAtSpacesAndIndented) {
  EXPECT_EQ(wrapped("one two three", 0, 7), "one two\nthree");
  EXPECT_EQ(wrapped("one two three", 4, 11), "one two\n    three");
  EXPECT_EQ(wrapped("one incomprehensible word", 2, 8), "one\n  incomprehensible\n  word");
  EXPECT_EQ(wrapped("", 4, 10), "");
  EXPECT_EQ(wrapped("one two three", 40, unlimited_width), "one two three");
}

TEST(Terminal, WidthsCountCharacters) {
  EXPECT_EQ(character_count("2 ε ≤ λ"), 7U);
  EXPECT_EQ(wrapped("ε ε ε ε", 0, 7), "ε ε ε ε");
  EXPECT_EQ(wrapped("ε ε ε ε", 0, 6), "ε ε ε\nε");
  EXPECT_EQ(first_characters("a ≤ b", 3), "a ≤");
  EXPECT_EQ(first_characters("a ≤ b", 9), "a ≤ b");
}

TEST(Terminal, RowsAreAlignedAndTheirLastCellIsWrapped) {
  EXPECT_EQ(aligned_rows({{"λ", "mm", "local feature size of the surface, at a point"}, {"sizing", "", "h"}}, 42),
            "λ       mm  local feature size of the\n"
            "            surface, at a point\n"
            "sizing      h\n");
  // Too narrow for a column of text: it goes below.
  EXPECT_EQ(aligned_rows({{"particles", "the particle system of the paper"}, {"  sweeps", ""}}, 30),
            "particles\n"
            "    the particle system of the\n"
            "    paper\n"
            "  sweeps\n");
}

// The two ends of a pseudo terminal, as a terminal's window and a program in it hold them.
class PseudoTerminal : public testing::Test {
 protected:
  void SetUp() override {
    window_ = posix_openpt(O_RDWR | O_NOCTTY);
    ASSERT_GE(window_, 0);
    ASSERT_EQ(grantpt(window_), 0);
    ASSERT_EQ(unlockpt(window_), 0);
    program_ = open(ptsname(window_), O_RDWR | O_NOCTTY);
    ASSERT_GE(program_, 0);
  }
  void TearDown() override {
    close(program_);
    close(window_);
  }
  std::optional<std::size_t> width_of_window(unsigned short columns) const {
    winsize size{};
    size.ws_row = 24;
    size.ws_col = columns;
    EXPECT_EQ(ioctl(window_, TIOCSWINSZ, &size), 0);
    return terminal_width(program_);
  }
  int window_ = -1;
  int program_ = -1;
};

TEST_F(PseudoTerminal, SaysHowWideItIs) {
  EXPECT_EQ(width_of_window(72), 72U);
  EXPECT_EQ(width_of_window(0), 100U);  // a terminal that does not know
}

TEST(Terminal, AFileHasNoWidth) {
  const int file = open("/dev/null", O_RDONLY);
  EXPECT_EQ(terminal_width(file), std::nullopt);
  close(file);
}

}  // namespace
}  // namespace isobench
