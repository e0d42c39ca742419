// The beginning [0, T] of a step, as a step of its own: for steps on which vertices go so far that the floats of the
// boxes make a point of the scene at t=0.
#pragma once
#include <span>
#include <vector>

#include "tamis/step.hpp"

namespace tamis {

/// T, a power of two, by which no two vertices have moved against each other by much more than a sixteenth of the
/// scene's width at t=0; 1 unless they move very far. `widening`: BoxFrame::widening, which spares most steps a look at
/// the vertices. REQUIRES (not checked: O(n)): finite positions of the points.
double beginning_of_long_step(const Step& step, std::span<const Index> points, double widening);

class Beginning {
 public:
  /// REQUIRES: 0 < length <= 1, a power of two.
  Beginning(const Step& step, std::span<const Index> points, double length);

  /// Refers to the start of the whole step. Vertices that are no points are anywhere.
  Step step() const { return {start_, end_}; }
  /// An upper bound, for all vertices and all times until `length`, of the distance between the two motions: rounding.
  double deviation() const { return deviation_; }

 private:
  Positions start_;
  std::vector<Point> end_;
  double deviation_ = 0;
};

}  // namespace tamis
