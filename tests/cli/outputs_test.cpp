// Files that a verb is told to write.
#include <gtest/gtest.h>

#include "cli/command.hpp"

namespace tamis::test {
namespace {

class Outputs : public testing::Test {
 protected:
  Outputs() { folder_.write_fall(); }

  CommandFolder folder_;
};

// Bug: hours of simulated frames are gone because a name was typed twice; contacts refused it, bench did not.
TEST_F(Outputs, NeverReplaceAnInput) {
  const auto& here = folder_.path();
  std::filesystem::create_symlink("below.obj", here / "link.obj");
  std::filesystem::create_hard_link(here / "below.obj", here / "hard.obj");
  const std::string before = bytes_of_file(here / "below.obj");
  for (const std::string verb : {"contacts above.obj below.obj", "bench above.obj below.obj --cold 1 --repeat 1"})
    for (const std::string out : {"below.obj", "./below.obj", "link.obj", "hard.obj"}) {
      const Outcome outcome = folder_.run(verb + " --out " + out);
      EXPECT_EQ(outcome.code, 2) << verb << out;
      EXPECT_NE(outcome.err.find("overwrite an input"), std::string::npos) << outcome.err;
    }
  EXPECT_EQ(bytes_of_file(here / "below.obj"), before);
}

// Bug: the table replaces the file that the answer is printed to, or the other way round.
TEST_F(Outputs, NeverReplaceTheAnswer) {
  const Outcome outcome = folder_.run("contacts above.obj below.obj --out both", "both");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.err.find("--out both"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace tamis::test
