#include "isobench/foundation/files/whole_files.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <fstream>
#include <functional>

#include "isobench/foundation/error.h"
#include "isobench/foundation/testing/file_size_limit.h"
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

std::string message_of(const std::function<void()>& write) {
  try {
    write();
  } catch (const Error& error) {
    return error.what();
  }
  return "written";
}

TEST(WholeFiles, OnAFullDiskTheOldFileStays) {
  const TestFolder folder;
  const fs::path path = folder.write("file.txt", "old");
  const FileSizeLimit full(20000);
  const std::string causes = "file.txt: cannot be written: File too large; raise the limit";
  // More than a stream holds back, so that writing fails before the end; and less, so that only closing fails.
  for (const std::size_t size : {std::size_t{1000000}, std::size_t{20001}}) {
    const std::string message = message_of([&] { write_text(path, std::string(size, 'x')); });
    EXPECT_NE(message.find(causes), std::string::npos) << message;
    const auto in_lines = [size](std::ostream& file) {
      for (std::size_t n = 0; n < size; n += 10) file << "123456789\n";
    };
    EXPECT_EQ(message_of([&] { write_text(path, in_lines); }), message);
    EXPECT_EQ(read_text(path), "old");
    EXPECT_EQ(files_in(folder), 1U);
  }
}

TEST(WholeFiles, SayWhatHelps) {
  EXPECT_STREQ(not_written("a/b", ENOSPC).what(),
               "a/b: cannot be written: No space left on device; free some space or write to another disk");
  EXPECT_STREQ(not_written("a/b", 0).what(),
               "a/b: cannot be written; check that its folder exists and that you may write there");
  const TestFolder folder;
  fs::create_directories(folder.path() / "taken" / "by a folder");
  const std::string message = message_of([&] { write_text(folder.path() / "taken", "text"); });
  EXPECT_NE(message.find("taken: cannot be written: Is a directory; check"), std::string::npos) << message;
  EXPECT_EQ(files_in(folder), 1U);
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
