// Names of files may hold any byte but two.
#include <gtest/gtest.h>

#include <algorithm>

#include "command/tests/command.hpp"

namespace tamis::test {
namespace {

class Names : public CommandTest {
 protected:
  /// Two frames in a folder, named with bytes that are no UTF-8 and that a terminal obeys.
  Names() {
    folder_.write_frame("f\xff/1\xfe\x1b[31m.obj", 1);
    folder_.write_frame("f\xff/2\xfe\x1b[31m.obj", -2);
  }
};

bool has_control(const std::string& text) {
  return std::any_of(text.begin(), text.end(), [](char c) { return (c >= 0 && c < ' ' && c != '\n') || c == 0x7f; });
}

// Bug: all the work is done, and then the JSON library refuses the name.
TEST_F(Names, ThatAreNoUtf8AreShownInJson) {
  const Outcome sequence = folder_.run("sequence f* --json");
  ASSERT_EQ(sequence.code, 1) << sequence.err;
  EXPECT_EQ(sequence.json()["steps"][0]["start"], "f\\xff/1\\xfe\x1b[31m.obj");
  const Outcome bench = folder_.run("bench f*/1* f*/2* --cold 1 --repeat 1 --json");
  ASSERT_EQ(bench.code, 0) << bench.err;
  EXPECT_EQ(bench.json()["rows"][0]["scene"], "1\\xfe\x1b[31m");
  EXPECT_FALSE(has_control(sequence.out + bench.out)) << "a terminal obeys them";
}

// Bug: a file named "\e]0;..." changes the title of the window, or worse.
TEST_F(Names, DoNotReachTheTerminalAsCommands) {
  for (const char* arguments :
       {"sequence f*", "bench f*/1* f*/2* --cold 1 --repeat 1", "info f*/1*x",
        "contacts f*/1* f*/2* --out $(printf '\\033]0;x\\007c.csv')", "dance$(printf '\\033[2J')",
        "contacts f*/1* f*/2* f*/1*", "is-free f*/1* f*/2* --isa $(printf '\\033')"}) {
    const Outcome outcome = folder_.run(arguments);
    EXPECT_FALSE(has_control(outcome.out)) << arguments << outcome.out;
    EXPECT_FALSE(has_control(outcome.err)) << arguments << outcome.err;
  }
}

// Bug: a comma in the name of a file shifts the cells of its row.
TEST_F(Names, AreQuotedInTables) {
  folder_.write_frame("a,\"b\".obj", 1);
  folder_.write_frame("end.obj", -2);
  const Outcome outcome =
      folder_.run("bench 'a,\"b\".obj' end.obj --question is-free --cold 1 --repeat 1 --out table.csv");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(bytes_of_file(folder_.path() / "table.csv").find("\n\"a,\"\"b\"\"\",1,"), std::string::npos)
      << bytes_of_file(folder_.path() / "table.csv");
}

}  // namespace
}  // namespace tamis::test
