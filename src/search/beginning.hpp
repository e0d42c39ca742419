// The beginning of a step that goes so far that floats cannot tell its start from a point: a step of its own, which the
// whole one follows but for rounding.
#pragma once
#include <span>
#include <vector>

#include "tamis/step.hpp"

namespace tamis {

/// The part of the step, a power of two, in which no two vertices part by much more than a sixteenth of what the scene
/// is wide at t=0; 1 unless they part very far. `widening`: as the frame of the boxes has it; spares most steps the
/// walk. REQUIRES (not checked: O(n)): finite positions of the points.
double beginning_of_long_step(const Step& step, std::span<const Index> points, double widening);

class Beginning {
 public:
  /// REQUIRES: 0 < length <= 1, a power of two.
  Beginning(const Step& step, std::span<const Index> points, double length);

  /// Keeps the start of the whole one. Vertices that are no points are anywhere.
  Step step() const { return {start_, end_}; }
  /// How far a vertex of the whole step is, at any time until `length`, from where it is in this one, at most.
  double deviation() const { return deviation_; }

 private:
  Positions start_;
  std::vector<Point> end_;
  double deviation_ = 0;
};

}  // namespace tamis
