// Files that a verb is told to write.
#include <gtest/gtest.h>

#include "command/tests/command.hpp"

namespace tamis::test {
namespace {

class Outputs : public FallTest {};

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

// Bug: a pipe, which has no name, is looked for beside the others of /proc/self/fd and "cannot be written".
TEST_F(Outputs, GoIntoPipes) {
  folder_.run("contacts above.obj below.obj --out usual.csv");
  const std::string usual = bytes_of_file(folder_.path() / "usual.csv");
  // A pipe of its own has the table alone; that of the answer has the table first.
  folder_.run("contacts above.obj below.obj --json --out /dev/fd/3 2>err 3>&1 >answer | cat >own; true");
  EXPECT_EQ(bytes_of_file(folder_.path() / "own"), usual) << bytes_of_file(folder_.path() / "err");
  folder_.run("contacts above.obj below.obj --out /dev/stdout 2>err | cat >both; true");
  EXPECT_TRUE(bytes_of_file(folder_.path() / "both").starts_with(usual + "mesh "))
      << bytes_of_file(folder_.path() / "err");
}

// Bug: a script that reads JSON from a pipe gets a table before it, or rows are cut in two by those of the table.
TEST_F(Outputs, DoNotMixWithAnAnswerThatMustStandAlone) {
  for (const std::string verb :
       {"contacts above.obj below.obj --json", "bench above.obj below.obj --cold 1 --repeat 1"}) {
    folder_.run(verb + " --out /dev/stdout 2>err | cat >both; true");
    EXPECT_EQ(bytes_of_file(folder_.path() / "both"), "") << verb;
    const std::string err = bytes_of_file(folder_.path() / "err");
    EXPECT_NE(err.find("--out /dev/stdout is the pipe of the answer"), std::string::npos) << verb << err;
  }
}

}  // namespace
}  // namespace tamis::test
