// Runs the built command as a user would.
#pragma once
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>

#include "support/temporary_folder.hpp"

namespace tamis::test {

struct Outcome {
  int code = -1;  ///< exit code; -1 if the command was killed
  std::string out;
  std::string err;

  nlohmann::json json() const { return nlohmann::json::parse(out); }
};

/// The built command, or what TAMIS_COMMAND names: scripts/test_windows.sh names a script that runs the Windows
/// program.
inline std::string command() {
  const char* other = std::getenv("TAMIS_COMMAND");
  return other != nullptr ? other : TAMIS_COMMAND;
}

/// A folder to run in, with the frames that several tests use.
class CommandFolder : public TemporaryFolder {
 public:
  /// `arguments` as for a shell whose working directory is the folder. `out_to` and `err_to`: a device that takes
  /// stdout or stderr, or "&-" to close it; if empty, the outcome has what was printed. `settings` come before the
  /// command: VARIABLE=VALUE, or a shell command and a semicolon.
  Outcome run(const std::string& arguments, const std::string& out_to = "", const std::string& err_to = "",
              const std::string& settings = "") const {
    const TemporaryFolder streams;
    const std::string out = out_to.empty() ? (streams.path() / "out").string() : out_to;
    const std::string err = err_to.empty() ? (streams.path() / "err").string() : err_to;
    const std::string line = "cd '" + path().string() + "' && " + settings + " '" + command() + "' " + arguments +
                             " </dev/null >" + out + " 2>" + err;
    const int status = std::system(line.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, out_to.empty() ? bytes_of_file(out) : "",
            err_to.empty() ? bytes_of_file(err) : ""};
  }

  /// A loose point at height `z` above a triangle.
  void write_frame(const std::string& name, double z) const {
    const std::string height = std::to_string(z);
    write(name, "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0.2 0.5 " + std::to_string(z) + "\nf 1 2 3\np 4\n");
  }
  /// The point falls through the triangle at t = 1/3, then moves away from it.
  void write_fall() const {
    write_frame("above.obj", 1);
    write_frame("below.obj", -2);
    write_frame("lower.obj", -4);
  }
};

/// A test that runs the command in a folder of its own.
class CommandTest : public testing::Test {
 protected:
  /// The command ends with exit code 2 and one line, which has `says` in it.
  void expect_refused(const std::string& arguments, const std::string& says) const {
    const Outcome outcome = folder_.run(arguments);
    EXPECT_EQ(outcome.code, 2) << arguments;
    EXPECT_EQ(outcome.out, "") << arguments;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << arguments << "\n" << outcome.err;
    EXPECT_TRUE(outcome.err.starts_with("tamis: ")) << outcome.err;
    EXPECT_NE(outcome.err.find(says), std::string::npos) << arguments << "\n" << outcome.err << "should say: " << says;
  }

  CommandFolder folder_;
};

/// A test with the frames of the fall.
class FallTest : public CommandTest {
 protected:
  FallTest() { folder_.write_fall(); }
};

}  // namespace tamis::test
