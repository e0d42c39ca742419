// Where vertices will be if they go on as in the last step.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "numerics/held_bytes.hpp"
#include "tamis/step.hpp"

namespace tamis {

class Forecast {
 public:
  /// Time is found by so many vertices.
  static constexpr std::size_t kSampleVertices = 64;

  /// How a step follows the predicted one.
  struct Fit {
    double start, end;  ///< as parts of the predicted step
    double deviation;   ///< a bound of how far any vertex is at any time from where it is predicted at some time
  };

  /// Predicts a step `steps` times as long as `step`, straight; for some of its vertices, which the caller keeps alive.
  void make(const Step& step, std::span<const Index> vertices, double steps);
  void clear() { from_.clear(); }
  bool is_made() const { return !from_.empty(); }
  /// Nothing if no step was predicted, if the deviation exceeds `most` or is not finite, or if `step` goes backwards.
  /// REQUIRES: positions of the vertices it was made for.
  std::optional<Fit> fit(const Step& step, double most) const;
  /// Where the predicted step begins and ends, of `count` vertices: those it was not made for are anywhere.
  struct Ends {
    std::vector<Point> start, end;
  };
  Ends ends(Index count) const;
  std::uint64_t memory_bytes() const { return held_bytes(from_, to_); }

 private:
  double nearest_time(const Positions& positions) const;
  std::optional<double> deviation(const Positions& positions, double t, double most) const;

  std::span<const Index> vertices_;
  std::vector<Point> from_, to_;  ///< of those
};

}  // namespace tamis
