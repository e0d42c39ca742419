#include "io/atomic_file.hpp"

#include <gtest/gtest.h>

#include "io/messages.hpp"
#include "support/temporary_folder.hpp"

namespace tamis::io {
namespace {

namespace fs = std::filesystem;

std::size_t files_in(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

class AtomicFiles : public testing::Test {
 protected:
  test::TemporaryFolder folder_;
};

// Bug: a crash or an error in the middle leaves half a file, or destroys the old one.
TEST_F(AtomicFiles, WithoutCommitTheOldFileStays) {
  const fs::path path = folder_.write("out.csv", "old");
  {
    AtomicFile file(path);
    file.append("half of it");
    EXPECT_EQ(test::bytes_of_file(path), "old");
  }
  EXPECT_EQ(test::bytes_of_file(path), "old");
  EXPECT_EQ(files_in(folder_.path()), 1u);
}

TEST_F(AtomicFiles, CommitReplacesTheFileAndLeavesNothingElse) {
  const fs::path path = folder_.write("out.csv", "old");
  AtomicFile file(path);
  file.append("new");
  file.append(" text");
  file.commit();
  EXPECT_EQ(test::bytes_of_file(path), "new text");
  EXPECT_EQ(files_in(folder_.path()), 1u);
}

// Bug: the rename replaces the link and the file behind it stays old.
TEST_F(AtomicFiles, WritesThroughASymbolicLink) {
  const fs::path path = folder_.write("deep/out.csv", "old");
  fs::create_symlink(path, folder_.path() / "link.csv");
  AtomicFile file(folder_.path() / "link.csv");
  file.append("new");
  file.commit();
  EXPECT_EQ(test::bytes_of_file(path), "new");
  EXPECT_TRUE(fs::is_symlink(folder_.path() / "link.csv"));
}

// Bug: /dev/null is renamed over; a pipe is refused.
TEST_F(AtomicFiles, WritesStraightIntoDevices) {
  AtomicFile file("/dev/null");
  file.append("gone");
  EXPECT_NO_THROW(file.commit());
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

// Bug: a full disk goes unnoticed.
TEST_F(AtomicFiles, AFullDeviceIsAnError) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  test::file_error("/dev/full", [] {
    AtomicFile file("/dev/full");
    file.append("too much");
    file.commit();
  });
}

TEST_F(AtomicFiles, PlacesThatCannotBeWrittenAreErrors) {
  const fs::path absent = folder_.path() / "absent" / "out.csv";
  for (const fs::path& path : {absent, folder_.path()})
    test::file_error(path.string(), [&] { require_writable(path); });
  EXPECT_EQ(files_in(folder_.path()), 0u);
}

TEST_F(AtomicFiles, AskingFirstLeavesNoTrace) {
  require_writable(folder_.path() / "out.csv");
  EXPECT_EQ(files_in(folder_.path()), 0u);
}

}  // namespace
}  // namespace tamis::io
