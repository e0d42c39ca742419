#include "cli/start_check.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "cli/command_line/verb.hpp"

namespace tamis::cli {

void StartCheck::declare(OptionList& options) {
  options.add_flag(
      "--check-start", is_asked_,
      "first ask whether the START passes through itself, as 'tamis intersections' does; if so, stop there "
      "with exit code 1");
}

bool StartCheck::passes(Detector& detector, const Positions& start) {
  if (is_asked_) intersections_ = detector.intersections(start).size();
  return intersections_ == 0;
}

int StartCheck::refuse(const Detector& detector, bool as_json, Json json) const {
  add_to(json);
  if (as_json) {
    print_json(json);
  } else {
    print_mesh(detector.mesh());
    fmt::print(
        "START           passes through itself: {} intersection{} ('tamis intersections START' lists them); "
        "nothing else was asked\n",
        grouped(intersections_), intersections_ == 1 ? "" : "s");
  }
  return kNo;
}

void StartCheck::print() const {
  fmt::print("{}\n", is_asked_
                         ? "START           passes through nothing, proven"
                         : "presupposes     a START that passes through nothing: 'tamis intersections START' tells");
}

void StartCheck::add_to(Json& json) const { json["start_intersections"] = is_asked_ ? Json(intersections_) : Json(); }

}  // namespace tamis::cli
