#include "files/atomic_file.hpp"

#include <gtest/gtest.h>

#include "files/file_bytes.hpp"
#include "files/system.hpp"
#include "files/tests/messages.hpp"
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

// Bug: two writers meet in one temporary file.
TEST_F(AtomicFiles, WritersOfOneFileDoNotMeet) {
  const fs::path path = folder_.path() / "out.csv";
  AtomicFile first(path), second(path);
  first.append("first");
  second.append("second");
  first.commit();
  EXPECT_EQ(test::bytes_of_file(path), "first");
  second.commit();
  EXPECT_EQ(test::bytes_of_file(path), "second");
}

// Bug: /dev/null is renamed over; a pipe is refused.
TEST_F(AtomicFiles, WritesStraightIntoDevices) {
  const fs::path null = system::is_stream("NUL") ? "NUL" : "/dev/null";
  AtomicFile file(null);
  file.append("gone");
  EXPECT_NO_THROW(file.commit());
  EXPECT_TRUE(system::is_stream(null));
  EXPECT_NO_THROW(require_writable(null));
}

// Bug: names in other alphabets become question marks, or those of other files.
TEST_F(AtomicFiles, NamesHaveAnyCharacters) {
  for (const std::string name : {"k\xc3\xbcgel.csv", "\xe7\x90\x83.csv", "\xf0\x9f\x8e\xb1 \xce\xb1.csv"}) {
    const fs::path path = folder_.path() / system::path_of(name);
    AtomicFile file(path);
    file.append(name);
    file.commit();
    EXPECT_EQ(FileBytes(path).view(), name);
    EXPECT_EQ(path.filename().string(), name);
  }
  EXPECT_EQ(files_in(folder_.path()), 3u);
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
