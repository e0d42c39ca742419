// The steps between frames of a sequence, asked one after the other.
#pragma once
#include <algorithm>
#include <vector>

#include "cli/moving_frames.hpp"
#include "cli/sequence_table.hpp"
#include "cli/step_files.hpp"
#include "io/scale_step.hpp"

namespace tamis::cli {

/// Calls f(SequenceStep) for each step that ends at a frame in [first, last), 1 <= first, with one detector; each is
/// cut into `substeps` equal ones and goes `scale` times as far.
template <class F>
void ask_steps(Detector& detector, const MovingFrames& frames, std::size_t first, std::size_t last, int substeps,
               double scale, const F& f) {
  if (first >= last) return;
  std::vector<Point> start = first == 1 ? frames.first().positions : frames.read(first - 1);
  for (std::size_t i = first; i < last; ++i) {
    std::vector<Point> end = frames.read(i);
    std::vector<Point> scaled = end;
    io::scale_step(start, scaled, scale);
    for (int part = 1; part <= substeps; ++part) {
      const auto at = [&](int n) {
        return n == 0 ? start : n == substeps ? scaled : between(start, scaled, static_cast<double>(n) / substeps);
      };
      const std::vector<Point> from = at(part - 1), to = at(part);
      const Tally tally = tally_of(detector.contacts({from, to}));
      f(SequenceStep{i, part, tally, detector.statistics().seconds, detector.statistics().rebuilt});
    }
    start = std::move(end);
  }
}

}  // namespace tamis::cli
