// Pictures of the paper's evaluation: drawn by another program, which may be missing.
#include <gtest/gtest.h>

#include <cstdlib>

#include "command/tests/command.hpp"

namespace tamis::test {
namespace {

namespace fs = std::filesystem;

class Pictures : public testing::Test {
 protected:
  Pictures() {
    folder_.write_frame("fall/f1.obj", 1);
    folder_.write_frame("fall/f2.obj", 0.5);
  }

  /// `settings` as in CommandFolder::run; `folder` in quotes as for a shell.
  Outcome evaluate(const std::string& folder, const std::string& settings = "") const {
    return folder_.run("paper --scenes none --frames fall=fall --out " + folder, "", "", settings);
  }
  void write_python(const std::string& script) const {
    fs::permissions(folder_.write("bin/python3", "#!/bin/sh\n" + script), fs::perms(0755));
  }
  bool has_picture(const fs::path& folder) const { return fs::exists(folder_.path() / folder / "fig5.png"); }

  CommandFolder folder_;
};

bool system_python_draws() { return std::system("/usr/bin/python3 -c 'import matplotlib' 2>/dev/null") == 0; }

// Bug: a shell takes the folder's name apart.
TEST_F(Pictures, AreDrawnInAFolderOfAnyName) {
  write_python("printf '%s\\n' \"$@\" >> calls\n");
  const std::string name = "it's \"here\" $(touch made); *";
  const Outcome outcome = evaluate("'it'\\''s \"here\" $(touch made); *'", "PATH=$PWD/bin:$PATH");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_NE(bytes_of_file(folder_.path() / "calls").find("/plot_paper.py\n" + name + "\n"), std::string::npos)
      << bytes_of_file(folder_.path() / "calls");
  EXPECT_FALSE(fs::exists(folder_.path() / "made"));
}

// Bug: an environment without matplotlib hides the system's Python, which has it.
TEST_F(Pictures, AreDrawnByThePythonThatHasMatplotlib) {
  write_python("exit 1\n");
  const Outcome outcome = evaluate("'labor $x$'", "PATH=$PWD/bin:$PATH");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(has_picture("labor $x$"), system_python_draws()) << outcome.err;
  EXPECT_EQ(outcome.err.empty(), system_python_draws()) << outcome.err;
}

// Bug: nothing says why there are no pictures, or pages of Python's own do.
TEST_F(Pictures, ThatFailSayWhereToLook) {
  write_python("case \"$1\" in -c) exit 0;; esac\necho too bad >&2\nexit 5\n");
  const Outcome outcome = evaluate("laboratory", "PATH=$PWD/bin:$PATH");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.err.find("too bad"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("plot_paper.py ended with exit code 5: run it on 'laboratory' to see why"),
            std::string::npos)
      << outcome.err;
  EXPECT_NE(bytes_of_file(folder_.path() / "laboratory/report.md"), "");
}

// Bug: the path of the source tree is compiled in, and an installed command never draws.
TEST_F(Pictures, AreDrawnByAnInstalledCommand) {
  write_python("printf '%s\\n' \"$@\" >> calls\n");
  const fs::path program = folder_.path() / "prefix/bin/tamis", built = TAMIS_COMMAND;
  fs::create_directories(program.parent_path());
  fs::copy_file(built, program);
  const std::string command = "PATH=$PWD/bin:$PATH '" + program.string() + "' ";
  const std::string arguments = "paper --scenes none --frames fall=fall --out laboratory";
  const Outcome without = folder_.run("--version; " + command + arguments);
  EXPECT_NE(without.err.find("/prefix/share/tamis/plot_paper.py is not there"), std::string::npos) << without.err;
  folder_.write("prefix/share/tamis/plot_paper.py", "");
  const Outcome with = folder_.run("--version; " + command + arguments);
  EXPECT_EQ(with.err, "");
  EXPECT_NE(bytes_of_file(folder_.path() / "calls").find("/prefix/share/tamis/plot_paper.py\n"), std::string::npos);
}

}  // namespace
}  // namespace tamis::test
