// A verb of the command: `tamis VERB ...`.
#pragma once
#include "command/command_line/option_list.hpp"

namespace tamis::cli {

inline constexpr int kSuccess = 0;
inline constexpr int kNo = 1;  ///< the answer is no: the step is not free, an answer was wrong
inline constexpr int kError = 2;

class Verb {
 public:
  virtual ~Verb() = default;

  virtual const char* name() const = 0;
  /// One line for the list of verbs.
  virtual const char* summary() const = 0;
  /// Shown below the options, a command a line.
  virtual const char* examples() const = 0;
  /// Declares options that write to members of this object.
  virtual void declare(OptionList& options) = 0;
  /// Does the work, prints to stdout, and returns the exit code; throws on any error.
  virtual int run() = 0;
};

}  // namespace tamis::cli
