// stdout and stderr that are closed or full.
#include <gtest/gtest.h>

#include <vector>

#include "command/tests/command.hpp"

namespace tamis::test {
namespace {

class Streams : public FallTest {
 protected:
  Streams() {
    folder_.write("quad.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");  // cut in two, with a note
    if (std::filesystem::exists("/dev/full")) unusable_.emplace_back("/dev/full");
  }

  std::vector<std::string> unusable_{"&-"};
};

// Bug: the sentence cannot be printed, the exception about that is thrown in the handler, and the command aborts.
TEST_F(Streams, AnErrorIsExitCodeTwoWithoutStderr) {
  for (const std::string& err : unusable_)
    for (const char* arguments : {"contacts zz below.obj", "dance", "", "is-free above.obj below.obj --scale x"})
      EXPECT_EQ(folder_.run(arguments, "", err).code, 2) << arguments << " 2>" << err;
}

// Bug: a note that nobody can read takes the answer away.
TEST_F(Streams, ANoteThatCannotBePrintedTakesNothingAway) {
  const Outcome usual = folder_.run("info quad.obj --json");
  ASSERT_NE(usual.err.find("note: "), std::string::npos);
  for (const std::string& err : unusable_) {
    const Outcome outcome = folder_.run("info quad.obj --json", "", err);
    EXPECT_EQ(outcome.code, 0) << err;
    EXPECT_EQ(outcome.out, usual.out);
  }
}

// Bug: the output file gets the number of the closed stream, and the answer or a note is printed into it.
TEST_F(Streams, NothingIsPrintedIntoTheOutputFile) {
  folder_.write("quad2.obj", bytes_of_file(folder_.path() / "quad.obj"));
  ASSERT_EQ(folder_.run("contacts quad.obj quad2.obj --out usual.csv").code, 0);
  const std::string usual = bytes_of_file(folder_.path() / "usual.csv");
  EXPECT_EQ(folder_.run("contacts quad.obj quad2.obj --out c.csv", "", "&-").code, 0);
  EXPECT_EQ(bytes_of_file(folder_.path() / "c.csv"), usual);
  EXPECT_EQ(folder_.run("contacts quad.obj quad2.obj --out d.csv", "&-", "").code, 2);
  EXPECT_EQ(bytes_of_file(folder_.path() / "d.csv"), usual);
}

// Bug: success is reported to a script that got nothing.
TEST_F(Streams, AnAnswerThatCannotBePrintedIsAnError) {
  for (const std::string& out : unusable_)
    for (const char* arguments : {"contacts above.obj below.obj", "is-free above.obj below.obj --json", "--help",
                                  "earliest --help", "sequence above.obj below.obj", "--version"}) {
      const Outcome outcome = folder_.run(arguments, out);
      EXPECT_EQ(outcome.code, 2) << arguments << " >" << out;
      EXPECT_NE(outcome.err.find("standard output"), std::string::npos) << arguments << outcome.err;
    }
}

}  // namespace
}  // namespace tamis::test
