// The steps between frames of a sequence, asked one after the other.
#pragma once
#include <vector>

#include "command/collapse_check.hpp"
#include "command/step_files.hpp"
#include "command/verbs/moving_frames.hpp"
#include "command/verbs/sequence_table.hpp"
#include "files/scale_step.hpp"

namespace tamis::cli {

/// The frames in [first, last) at which steps end, 1 <= first; each step is cut into `substeps` equal ones, and goes
/// `scale` times as far.
struct StepRange {
  std::size_t first, last;
  int substeps = 1;
  double scale = 1;
};

/// Calls f(end, part, step) for each part of each step, until f returns false. `part` is counted from 1.
template <class F>
void for_each_step(const MovingFrames& frames, const StepRange& range, const F& f) {
  if (range.first >= range.last) return;
  std::vector<Point> start = range.first == 1 ? frames.first().positions : frames.read(range.first - 1);
  for (std::size_t i = range.first; i < range.last; ++i) {
    std::vector<Point> end = frames.read(i);
    if (!frames.follows(i)) {
      start = std::move(end);
      continue;
    }
    note_units(frames.paths()[i].string(), start, end);
    std::vector<Point> scaled = end;
    io::scale_step(start, scaled, range.scale);
    for (int part = 1; part <= range.substeps; ++part) {
      const auto at = [&](int n) {
        return n == 0                ? start
               : n == range.substeps ? scaled
                                     : between(start, scaled, static_cast<double>(n) / range.substeps);
      };
      const std::vector<Point> from = at(part - 1), to = at(part);
      if (!asked_of("the step to " + frames.paths()[i].string(), [&] { return f(i, part, Step{from, to}); })) return;
    }
    start = std::move(end);
  }
}

/// Asks about each part, without what has collapsed at its ends, and calls f(SequenceStep). `own`: options of each
/// question.
template <class F>
void ask_steps(Detector& whole, const MovingFrames& frames, const StepRange& range, const QueryOptions& own,
               const F& f) {
  UncollapsedAsker asker(whole);
  for_each_step(frames, range, [&](std::size_t end, int part, const Step& step) {
    Detector* detector = asker.detector_for(frames.paths()[end - 1].string(), frames.paths()[end].string(), step);
    const Tally tally = detector ? tally_of(detector->contacts(step, own)) : Tally();
    const Statistics& statistics = detector ? detector->statistics() : Statistics();
    f(SequenceStep{end, part, tally, statistics.seconds, statistics.rebuilt, !asker.collapse().passes()});
    return true;
  });
}

}  // namespace tamis::cli
