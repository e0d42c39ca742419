// Many pairs in one mesh, all in one place, each asked only about itself: the way of a detector, through boxes, filters
// and roots in SIMD lanes, with unlike neighbours in each block of lanes.
#pragma once
#include <vector>

#include "oracle/oracle.hpp"
#include "tamis/detector.hpp"
#include "tamis/pair.hpp"

namespace tamis::test {

class OnePlace {
 public:
  static constexpr Index kPairs = 48;

  explicit OnePlace(PairKind kind);
  /// The answers in the order of the motions. REQUIRES: kPairs motions, each of this kind.
  const std::vector<PairResult>& answers(const std::vector<oracle::Motion>& motions);

 private:
  Detector detector_;
  std::vector<Point> start_, end_;
  std::vector<PairResult> answers_;
};

}  // namespace tamis::test
