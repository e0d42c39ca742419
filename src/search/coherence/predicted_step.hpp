// A step predicted from the last one: where vertices will be if they continue like that for several steps.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "numbers/held_bytes.hpp"
#include "tamis/step.hpp"

namespace tamis {

class PredictedStep {
 public:
  /// A step's place in time within the predicted one is found from about so many vertices.
  static constexpr std::size_t kSampleVertices = 64;

  /// How a step follows the predicted one.
  struct Fit {
    double start, end;  ///< times of the predicted step
    double deviation;   ///< no vertex, at any time, is farther from where it is predicted at the matching time
  };

  /// Predicts `steps` steps of these displacements, `step` being the first, as one straight step, for some of the
  /// vertices. Keeps the span `vertices`.
  void make(const Step& step, std::span<const Index> vertices, double steps);
  bool is_made() const { return !from_.empty(); }
  /// How `step` follows the prediction. Nothing if no step was predicted, if the deviation exceeds `most` or is not
  /// finite, or if `step` goes backwards.
  /// REQUIRES: positions of the vertices it was made for.
  std::optional<Fit> fit(const Step& step, double most) const;
  /// Start and end of the predicted step, of `count` vertices: those that make() was not given are anywhere.
  struct Ends {
    std::vector<Point> start, end;
  };
  Ends ends(Index count) const;
  std::uint64_t memory_bytes() const { return held_bytes(from_, to_); }

 private:
  double nearest_time(const Positions& positions) const;
  std::optional<double> deviation(const Positions& positions, double t, double most) const;

  std::span<const Index> vertices_;
  std::vector<Point> from_, to_;  ///< of vertices_
};

}  // namespace tamis
