// Other programs, run without a shell.
#pragma once
#include <string>
#include <vector>

namespace tamis::lab {

inline constexpr int kNotStarted = -1;

/// Runs `words`, the program and its arguments as they are, to its end; a name without a slash is looked for in PATH.
/// It reads nothing, and what it prints goes nowhere. Returns its exit code, 128 and more if a signal ended it,
/// kNotStarted if there is no such program.
int run_quietly(std::vector<std::string> words);

}  // namespace tamis::lab
