#include "command/verbs/sequence_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "command/command_line/printable.hpp"
#include "files/system.hpp"

namespace tamis::cli {
namespace {

/// What a step did to the hierarchy. It is unused if all pairs were listed ahead, and in method `brute`.
const char* tree_of(const SequenceStep& step) {
  if (step.rebuilt) return "built";
  return step.seconds.build > 0 ? "refitted" : "unused";
}

}  // namespace

SequenceTable::SequenceTable(std::vector<std::filesystem::path> frames, int substeps, bool json)
    : frames_(std::move(frames)), substeps_(substeps), json_(json) {
  for (const auto& frame : frames_)
    width_ =
        std::max(width_, static_cast<int>(printable(frame.filename().string()).size() + part_of(substeps_).size()));
}

/// " 3/20", or nothing if steps are whole.
std::string SequenceTable::part_of(int part) const {
  return substeps_ == 1 ? "" : fmt::format(" {}/{}", part, substeps_);
}

void SequenceTable::print_head(const Detector& detector) const {
  if (json_) return;
  print_asked(detector);
  fmt::print("\n{:>5} {:<{}} {:>11} {:>11} {:>14} {:>10}  {}\n", "step", "end", width_, "vertex-face", "edge-edge",
             "free until", "time", "tree");
}

void SequenceTable::add(const SequenceStep& step) {
  total_.add_counts(step.tally);
  seconds_ += step.seconds.total;
  free_steps_ += step.is_free() ? 1 : 0;
  ++steps_asked_;
  if (!json_) return print_row(step);
  Json json{{"start", frames_[step.end - 1].string()},
            {"end", frames_[step.end].string()},
            {"contacts", json_of(step.tally)}};
  if (substeps_ > 1) json["substep"] = step.part;
  add_bracket(json, step.is_free(), step.free_before(), step.tally.toi_upper);
  json["collapsed"] = step.has_collapsed;
  json["seconds"] = json_of(step.seconds);
  json["rebuilt"] = step.rebuilt;
  steps_.push_back(std::move(json));
}

void SequenceTable::print_row(const SequenceStep& step) const {
  const Tally& tally = step.tally;
  fmt::print("{:>5} {:<{}} {:>11} {:>11} {:>14} {:>10}  {}{}\n", step.end,
             printable(frames_[step.end].filename().string()) + part_of(step.part), width_, grouped(tally.vf),
             grouped(tally.ee), step.is_free() ? std::string("end") : no_later(step.free_before()),
             readable(step.seconds.total), step.has_collapsed ? "collapsed" : tree_of(step),
             of_loose_points(tally.ve, tally.vv));
  std::fflush(stdout);
}

void SequenceTable::print_totals(const Options& options, const Statistics& statistics, const StartCheck& start) {
  if (!json_) {
    fmt::print("{:>5} {:<{}} {:>11} {:>11} {:>14} {:>10}{}\n", "total", "", width_, grouped(total_.vf),
               grouped(total_.ee), fmt::format("{}/{} free", free_steps_, steps_asked_), readable(seconds_),
               of_loose_points(total_.ve, total_.vv));
    if (is_free()) start.print();
    return;
  }
  Json json{{"steps", std::move(steps_)}, {"contacts", json_of(total_)}, {"free_steps", free_steps_}};
  start.add_to(json);
  json.update({{"seconds", {{"total", seconds_}}},
               {"peak_memory_bytes", system::peak_memory_bytes()},
               {"threads", statistics.threads},
               {"min_separation", options.min_separation},
               {"radii", options.radii},
               {"isa", name_of(statistics.isa)}});
  print_json(json);
}

}  // namespace tamis::cli
