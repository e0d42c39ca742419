#include "command/start_check.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdio>

#include "command/collapse_check.hpp"
#include "command/command_line/printable.hpp"
#include "command/command_line/verb.hpp"
#include "command/step_files.hpp"

namespace tamis::cli {

void StartCheck::declare(OptionList& options) {
  options.add_flag("--check-start", is_asked_,
                   "first test whether START passes through itself, as 'tamis intersections' does; if so, stop there "
                   "with exit code 1");
}

void StartCheck::declare_for_bodies(OptionList& options) {
  options.add_flag("--check-start", is_asked_,
                   "first test whether bodies pass through each other where they start, or a deforming one through "
                   "itself; if so, stop there with exit code 1. Two static bodies are not tested");
}

bool StartCheck::passes(Detector& detector, const Positions& start) {
  if (!is_asked_) return true;
  UncollapsedAsker asker(detector);
  Detector* asked = asker.detector_for("START", "START", {start, start});
  if (asked) intersections_ = asked->intersections(start).size();
  has_collapsed_ = !asker.collapse().passes();
  if (intersections_ > 0 && !has_collapsed_) note_coincident(detector.mesh(), start);
  return intersections_ == 0 && !has_collapsed_;
}

bool StartCheck::passes(World& world) {
  if (!is_asked_) return true;
  const std::vector<BodyIntersection> all = world.intersections();
  intersections_ = all.size();
  if (!all.empty()) first_ = all.front();
  return all.empty();
}

int StartCheck::refuse(const Detector& detector, bool as_json, Json json) const {
  add_to(json);
  if (as_json) {
    print_json(json);
  } else {
    print_asked(detector);
    if (has_collapsed_) fmt::print("START           has objects that have collapsed; nothing else was tested\n");
    if (intersections_ == 0) return kNo;
    fmt::print(
        "START           passes through itself: {} intersection{} ('tamis intersections START' lists them); "
        "nothing else was tested\n",
        grouped(intersections_), intersections_ == 1 ? "" : "s");
  }
  return kNo;
}

void StartCheck::print_refused(const std::vector<std::string>& names) const {
  const auto name = [&](std::size_t which) { return printable(names[static_cast<std::size_t>(first_.bodies[which])]); };
  const Edge& edge = first_.edge;
  const Face& face = first_.face;
  fmt::print(
      "START           bodies pass through each other, or through themselves: {} intersection{}, the first of edge {} "
      "{} of {} and face {} {} {} of {}; nothing else was tested\n",
      grouped(intersections_), intersections_ == 1 ? "" : "s", edge[0], edge[1], name(0), face[0], face[1], face[2],
      name(1));
}

void StartCheck::add_refused_to(Json& json, const std::vector<std::string>& names) const {
  add_to(json);
  const auto name = [&](std::size_t which) { return names[static_cast<std::size_t>(first_.bodies[which])]; };
  json["start_intersection"] = {{"bodies", std::array{name(0), name(1)}}, {"edge", first_.edge}, {"face", first_.face}};
}

void StartCheck::print() const {
  fmt::print("{}\n", is_asked_
                         ? "START           no edge passes through a triangle that shares no vertex with it, proven"
                         : "presupposes     a START that passes through nothing: 'tamis intersections START' tells");
}

void StartCheck::print_for_bodies() const {
  fmt::print("{}\n",
             is_asked_
                 ? "START           no body that moves passes through another, no deforming one through itself, "
                   "proven"
                 : "presupposes     bodies that do not pass through each other at the START: --check-start tests this");
}

void StartCheck::add_to(Json& json) const { json["start_intersections"] = is_asked_ ? Json(intersections_) : Json(); }

}  // namespace tamis::cli
