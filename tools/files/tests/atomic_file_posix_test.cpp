// What output files do with links, permissions, signals, pipes and limits.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <csignal>

#include "files/atomic_file.hpp"
#include "files/tests/messages.hpp"
#include "support/temporary_folder.hpp"

namespace tamis::io {
namespace {

namespace fs = std::filesystem;

std::size_t entries_in(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

class AtomicFilesOnPosix : public testing::Test {
 protected:
  test::TemporaryFolder folder_;
};

// Bug: the rename replaces the link and the file behind it stays old.
TEST_F(AtomicFilesOnPosix, WritesThroughASymbolicLink) {
  const fs::path path = folder_.write("deep/out.csv", "old");
  fs::create_symlink(path, folder_.path() / "link.csv");
  AtomicFile file(folder_.path() / "link.csv");
  file.append("new");
  file.commit();
  EXPECT_EQ(test::bytes_of_file(path), "new");
  EXPECT_TRUE(fs::is_symlink(folder_.path() / "link.csv"));
}

// Bug: a link to a disk that was prepared for the results is replaced by a file on this one.
TEST_F(AtomicFilesOnPosix, WritesThroughALinkToWhereNothingIsYet) {
  fs::create_directory(folder_.path() / "deep");
  fs::create_symlink("deep/second", folder_.path() / "first");
  fs::create_symlink("out.csv", folder_.path() / "deep/second");
  AtomicFile file(folder_.path() / "first");
  file.append("new");
  file.commit();
  EXPECT_TRUE(fs::is_symlink(folder_.path() / "first"));
  EXPECT_TRUE(fs::is_symlink(folder_.path() / "deep/second"));
  EXPECT_EQ(test::bytes_of_file(folder_.path() / "deep/out.csv"), "new");
  fs::create_symlink("round", folder_.path() / "round");
  test::file_error((folder_.path() / "round").string(), [&] { AtomicFile{folder_.path() / "round"}; });
}

// Bug: a private file can be read by everyone once it was written again.
TEST_F(AtomicFilesOnPosix, KeepsThePermissionsOfTheFileItReplaces) {
  for (const auto mode : {fs::perms(0600), fs::perms(0640), fs::perms(0666), fs::perms(0755)}) {
    const fs::path path = folder_.write("out.csv", "old");
    fs::permissions(path, mode);
    AtomicFile file(path);
    for (const auto& entry : fs::directory_iterator(folder_.path()))
      EXPECT_EQ(entry.status().permissions() & ~mode, fs::perms::none) << entry.path() << ": while it is written";
    file.append("new");
    file.commit();
    EXPECT_EQ(fs::status(path).permissions(), mode);
  }
}

// Bug: the temporary name is the longer one, and a name that is just short enough is refused.
TEST_F(AtomicFilesOnPosix, WritesTheLongestNameThereIs) {
  const fs::path path = folder_.path() / std::string(255, 'x');
  AtomicFile file(path);
  file.commit();
  EXPECT_TRUE(fs::exists(path));
}

/// What an interrupted program does; the child of a death test.
void write_and_raise(const fs::path& path) {
  AtomicFile file(path);
  file.append("half of it");
  raise(SIGTERM);
}

// Bug: an interrupted run leaves half a file under the final name, or a later run reads what it left.
TEST_F(AtomicFilesOnPosix, AKilledProcessLeavesTheOldFileAndOneThatSaysItIsAPart) {
  const fs::path path = folder_.write("out.csv", "old");
  EXPECT_EXIT(write_and_raise(path), testing::KilledBySignal(SIGTERM), "");
  EXPECT_EQ(test::bytes_of_file(path), "old");
  ASSERT_EQ(entries_in(folder_.path()), 2u);
  for (const auto& entry : fs::directory_iterator(folder_.path()))
    EXPECT_TRUE(entry.path() == path || entry.path().extension() == ".part") << entry.path();
  AtomicFile(path).commit();
  EXPECT_EQ(entries_in(folder_.path()), 2u);
}

/// As under `ulimit -f 1`.
void write_beyond_limit(const fs::path& path) {
  std::signal(SIGXFSZ, SIG_IGN);  // as the command does
  const rlimit small{1000, 1000};
  setrlimit(RLIMIT_FSIZE, &small);
  AtomicFile file(path);
  file.append(std::string(100'000, 'x'));
  file.commit();
}

// Bug: a limit of the shell kills the process in the middle of the file.
TEST_F(AtomicFilesOnPosix, AFileThatMayNotGrowIsAnError) {
  const fs::path path = folder_.write("out.csv", "old");
  const auto try_to_write = [&] {
    const std::string message = test::file_error(path.string(), [&] { write_beyond_limit(path); });
    _exit(test::contains(message, "File too large") && entries_in(folder_.path()) == 1 ? 7 : 1);
  };
  EXPECT_EXIT(try_to_write(), testing::ExitedWithCode(7), "");
  EXPECT_EQ(test::bytes_of_file(path), "old");
}

fs::path path_of(int descriptor) { return fmt::format("/dev/fd/{}", descriptor); }

// Bug: the link's text, as "pipe:[7]", is taken for the name of a file.
TEST_F(AtomicFilesOnPosix, WritesStraightIntoAPipeThatIsOpen) {
  std::array<int, 2> ends{};
  ASSERT_EQ(pipe(ends.data()), 0);
  EXPECT_NO_THROW(require_writable(path_of(ends[1])));
  AtomicFile file(path_of(ends[1]));
  file.append("through");
  file.commit();
  std::array<char, 8> bytes{};
  EXPECT_EQ(read(ends[0], bytes.data(), bytes.size()), 7);
  EXPECT_STREQ(bytes.data(), "through");
  close(ends[0]);
  close(ends[1]);
  test::file_error(path_of(ends[1]).string(), [&] { require_writable(path_of(ends[1])); });
}

// Bug: whoever opened the file is left with one that has no name any more, or loses what was in it.
TEST_F(AtomicFilesOnPosix, WritesAtTheEndOfAFileThatIsOpen) {
  const fs::path path = folder_.write("out.csv", "old, ");
  const int open_file = open(path.c_str(), O_WRONLY | O_APPEND);
  require_writable(path_of(open_file));
  AtomicFile file(path_of(open_file));
  file.append("new");
  file.commit();
  EXPECT_EQ(write(open_file, ", more", 6), 6);
  close(open_file);
  EXPECT_EQ(test::bytes_of_file(path), "old, new, more");
  EXPECT_EQ(entries_in(folder_.path()), 1u);
}

// Bug: a full disk goes unnoticed.
TEST_F(AtomicFilesOnPosix, AFullDeviceIsAnError) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  test::file_error("/dev/full", [] {
    AtomicFile file("/dev/full");
    file.append("too much");
    file.commit();
  });
}

}  // namespace
}  // namespace tamis::io
