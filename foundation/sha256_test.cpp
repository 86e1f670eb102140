#include "isobench/foundation/sha256.h"

#include <gtest/gtest.h>

#include "isobench/foundation/error.h"
#include "isobench/foundation/testing/test_files.h"
#include "isobench/foundation/testing/test_folder.h"

namespace isobench {
namespace {

// The examples that NIST publishes with FIPS 180-4.
TEST(Sha256Known, Answers) {
  EXPECT_EQ(sha256_of_text(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256_of_text("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256_of_text("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
}

TEST(Sha256Known, AFileHasTheSumOfItsBytes) {
  const TestFolder folder;
  const std::string bytes(200001, 'a');
  EXPECT_EQ(sha256_of_file(folder.write("a", bytes)), sha256_of_text(bytes));
  EXPECT_THROW(sha256_of_file(folder.path() / "none"), DataError);
}

}  // namespace
}  // namespace isobench
