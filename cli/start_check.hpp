// What an answer about contacts presupposes: that nothing passes through anything at the start. Two sheets that are
// through each other may move without a contact.
#pragma once
#include <string>
#include <vector>

#include "cli/command_line/option_list.hpp"
#include "cli/report.hpp"
#include "tamis/world.hpp"

namespace tamis::cli {

/// `--check-start`: asks for the intersections of the start before the verb asks its own question.
class StartCheck {
 public:
  void declare(OptionList& options);
  void declare_for_bodies(OptionList& options);
  /// May the verb's own question be asked? False: the start passes through itself, which the option wanted to know.
  bool passes(Detector& detector, const Positions& start);
  /// The same of bodies, where they are. Keeps the first that there is.
  bool passes(World& world);
  /// Of a start that does not pass. `json`: what it adds to. Returns the exit code.
  int refuse(const Detector& detector, bool as_json, Json json) const;
  /// Of bodies, by their names.
  void print_refused(const std::vector<std::string>& names) const;
  void add_refused_to(Json& json, const std::vector<std::string>& names) const;

  /// Below an answer that says "free": what was presupposed, or that it was asked.
  void print() const;
  void print_for_bodies() const;
  /// start_intersections: how many, null if nobody asked.
  void add_to(Json& json) const;

 private:
  bool is_asked_ = false;
  std::size_t intersections_ = 0;
  BodyIntersection first_{};  ///< of bodies, if there are any
};

}  // namespace tamis::cli
