// Checks what an answer about contacts presupposes: that nothing passes through anything at the start. Two sheets that
// pass through each other may move without a contact.
#pragma once
#include <string>
#include <vector>

#include "command/command_line/option_list.hpp"
#include "command/report.hpp"
#include "tamis/world.hpp"

namespace tamis::cli {

/// `--check-start`: asks for the intersections of the start before the verb asks its own question.
class StartCheck {
 public:
  void declare(OptionList& options);
  void declare_for_bodies(OptionList& options);
  /// May the verb ask its own question? False if the option is given and the start passes through itself.
  bool passes(Detector& detector, const Positions& start);
  /// The same for bodies at their present places. Keeps the first intersection. With --check-overlap no body may be
  /// inside another, either.
  bool passes(World& world);
  /// Prints that the start does not pass, as JSON by adding to `json`. Returns the exit code.
  int refuse(const Detector& detector, bool as_json, Json json) const;
  /// The same for bodies. `names`: by the bodies' numbers.
  void print_refused(const std::vector<std::string>& names) const;
  void add_refused_to(Json& json, const std::vector<std::string>& names) const;

  /// Prints, below an answer that says "free", that a clean start is presupposed, or that it was asked for.
  void print() const;
  void print_for_bodies() const;
  /// Adds the key start_intersections: their number, null if the option is not given.
  void add_to(Json& json) const;

 private:
  bool is_asked_ = false, asks_overlap_ = false, overlaps_ = false;
  std::size_t intersections_ = 0;
  bool has_collapsed_ = false;  ///< then what has collapsed was not asked about
  BodyIntersection first_{};    ///< the first intersection of bodies, if there is one
};

}  // namespace tamis::cli
