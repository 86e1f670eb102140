#include "isobench/foundation/files/whole_files.h"

#include <gtest/gtest.h>

#include <fstream>

#include "isobench/foundation/error.h"
#include "isobench/foundation/testing/test_folder.h"

namespace isobench {
namespace {

namespace fs = std::filesystem;

std::size_t files_in(const TestFolder& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder.path()), {}));
}

TEST(WholeFiles, GiveBackWhatWasWritten) {
  const TestFolder folder;
  const fs::path path = folder.path() / "file.txt";
  std::string bytes = "a\r\nb";
  bytes += '\0';
  bytes.append(100000, 'x');
  write_text(path, bytes);
  EXPECT_EQ(read_text(path), bytes);
  write_text(path, [](std::ostream& file) { file << 1 << '\n'; });
  EXPECT_EQ(read_text(path), "1\n");
  EXPECT_EQ(files_in(folder), 1U);
}

TEST(WholeFiles, ThatCannotBeReadOrWrittenAreNamed) {
  const TestFolder folder;
  const fs::path missing = folder.path() / "missing.txt";
  EXPECT_THROW(read_text(missing), DataError);
  EXPECT_THROW(read_text(folder.path()), DataError);
  EXPECT_EQ(read_text_or_empty(missing), "");
  try {
    write_text(folder.path() / "none" / "file.txt", "text");
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("none/file.txt: cannot be written"), std::string::npos) << error.what();
  }
}

TEST(WholeFiles, AFailedWriterLeavesTheOldFile) {
  const TestFolder folder;
  const fs::path path = folder.write("file.txt", "old");
  const auto fails = [](std::ostream& file) {
    file << "new";
    throw Error("half way");
  };
  EXPECT_THROW(write_text(path, fails), Error);
  EXPECT_EQ(read_text(path), "old");
  EXPECT_EQ(files_in(folder), 1U);
}

TEST(PartialFile, GetsItsNameWhenItIsComplete) {
  const TestFolder folder;
  const fs::path target = folder.path() / "mesh.ply";
  {
    PartialFile partial(target);
    EXPECT_EQ(partial.path().parent_path(), target.parent_path());
    EXPECT_EQ(partial.path().extension(), ".ply");
    EXPECT_TRUE(partial.path().filename().string().starts_with("mesh.ply.tmp-"));
    std::ofstream(partial.path()) << "whole";
    EXPECT_FALSE(fs::exists(target));
    partial.complete();
  }
  EXPECT_EQ(read_text(target), "whole");
  {
    const PartialFile partial(target);
    std::ofstream(partial.path()) << "half";
  }
  EXPECT_EQ(read_text(target), "whole");
  EXPECT_EQ(files_in(folder), 1U);
}

TEST(LastLines, AreThoseThatSaySomething) {
  const TestFolder folder;
  const fs::path log = folder.write("log.txt", "first\n\nsecond\n  \nthird\n...\n");
  EXPECT_EQ(last_lines(log, 2), "second | third");
  EXPECT_EQ(last_lines(log, 5), "first | second | third");
  EXPECT_EQ(last_lines(log, 5, 6), "second | third");
  EXPECT_EQ(last_lines(folder.path() / "missing", 3), "");
  EXPECT_EQ(last_lines(folder.write("empty.txt", ""), 3), "");
  const fs::path lengthy = folder.write("lengthy.txt", std::string(10000, 'x') + "\nend\n");
  EXPECT_EQ(last_lines(lengthy, 2), std::string(4091, 'x') + " | end");
}

TEST(ScratchFolder, GoesWithItsContents) {
  const TestFolder parent;
  {
    const ScratchFolder scratch(parent.path());
    EXPECT_EQ(scratch.path().parent_path(), parent.path());
    EXPECT_TRUE(scratch.path().filename().string().starts_with(".scratch-"));
    fs::create_directories(scratch.path() / "a" / "b");
    const ScratchFolder other(parent.path(), "other-");
    EXPECT_EQ(files_in(parent), 2U);
  }
  EXPECT_EQ(files_in(parent), 0U);
  EXPECT_THROW(ScratchFolder(parent.path() / "none"), Error);
}

}  // namespace
}  // namespace isobench
