// Runs other programs, without a shell.
#pragma once
#include <string>
#include <vector>

namespace tamis::lab {

inline constexpr int kNotStarted = -1;

/// Runs `words`, a program and its arguments, and waits for its end. A name without a slash is looked for in PATH. The
/// program's input is empty, its output discarded. Returns its exit code, 128 + the signal if a signal ended it,
/// kNotStarted if it could not be started.
int run_quietly(std::vector<std::string> words);

}  // namespace tamis::lab
