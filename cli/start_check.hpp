// What an answer about contacts presupposes: that nothing passes through anything at the start. Two sheets that are
// through each other may move without a contact.
#pragma once
#include "cli/command_line/option_list.hpp"
#include "cli/report.hpp"

namespace tamis::cli {

/// `--check-start`: asks for the intersections of the start before the verb asks its own question.
class StartCheck {
 public:
  void declare(OptionList& options);
  /// May the verb's own question be asked? False: the start passes through itself, which the option wanted to know.
  bool passes(Detector& detector, const Positions& start);
  /// Of a start that does not pass. `json`: what it adds to. Returns the exit code.
  int refuse(const Detector& detector, bool as_json, Json json) const;

  /// Below an answer that says "free": what was presupposed, or that it was asked.
  void print() const;
  /// start_intersections: how many, null if nobody asked.
  void add_to(Json& json) const;

 private:
  bool is_asked_ = false;
  std::size_t intersections_ = 0;
};

}  // namespace tamis::cli
