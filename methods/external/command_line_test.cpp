#include "isobench/methods/external/command_line.h"

#include <gtest/gtest.h>

#include "isobench/foundation/error.h"

namespace isobench::external {
namespace {

using Words = std::vector<std::string>;

TEST(CommandLine, IsSplitAsAShellWouldAndTakesNothingElseForSpecial) {
  EXPECT_EQ(split_words("  a  b\tc\nd "), (Words{"a", "b", "c", "d"}));
  EXPECT_EQ(split_words("sh -c 'a \"b\" \\n' \"x 'y' \\\"z\\\" \\n\" p\\ q '' r's'\"t\""),
            (Words{"sh", "-c", "a \"b\" \\n", "x 'y' \"z\" \\n", "p q", "", "rst"}));
  EXPECT_EQ(split_words("a; b | c > $HOME `d` *"), (Words{"a;", "b", "|", "c", ">", "$HOME", "`d`", "*"}));
  EXPECT_TRUE(split_words(" \n").empty());
  EXPECT_THROW(split_words("a 'b"), UsageError);
  EXPECT_THROW(split_words("a \"b"), UsageError);
}

TEST(CommandLine, JoinedWordsAreSplitToTheSame) {
  const Words words = {"a", "", "b c", "it's", "\"", "back\\slash", "line\nbreak", "{x}", "$y"};
  EXPECT_EQ(split_words(joined(words)), words);
}

TEST(CommandLine, PlaceholdersAreFilledScaledAndEscaped) {
  const std::map<std::string, Value> values = {{"edge_length", 0.5}, {"vertices", 1001LL}, {"volume", "v.nrrd"}};
  EXPECT_EQ(filled("{volume}:scalar:V", values), "v.nrrd:scalar:V");
  EXPECT_EQ(filled("{edge_length}/{edge_length*3}/{edge_length/0.25}", values), "0.5/1.5/2");
  EXPECT_EQ(filled("{vertices},{vertices/2},{vertices*0.001}", values), "1001,501,1");
  EXPECT_EQ(filled("{{volume}} }}{{", values), "{volume} }{");
  EXPECT_EQ(placeholders_in("{a}{b*2}{{c}}"), (Words{"a", "b"}));
  for (const char* wrong :
       {"{volume", "{edge_length*x}", "{edge_length*0}", "{edge_length/}", "{volume*2}", "{other}"}) {
    EXPECT_THROW(filled(wrong, values), UsageError) << wrong;
  }
}

}  // namespace
}  // namespace isobench::external
