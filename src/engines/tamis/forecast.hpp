// Where vertices will be if they go on as they do.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "tamis/step.hpp"

namespace tamis {

class Forecast {
 public:
  /// Time is found by so many vertices.
  static constexpr std::size_t kSample = 64;

  /// How a step goes along the way that was foreseen.
  struct Fit {
    double start, end;  ///< as parts of the way
    double stray;       ///< a bound of how far any vertex is at any time from where it is foreseen at some time
  };

  /// `steps` times as far as `step` goes, straight; for some of its vertices, which the caller keeps alive.
  void make(const Step& step, std::span<const Index> vertices, double steps);
  void clear() { from_.clear(); }
  /// REQUIRES: as many positions as it was made of. Nothing if none was made, if stray exceeds `most`, or is not
  /// finite, or if the step goes backwards.
  std::optional<Fit> fit(const Step& step, double most) const;
  /// All of it; other vertices are anywhere.
  Step way() const { return {from_, to_}; }
  std::uint64_t memory_bytes() const { return (from_.capacity() + to_.capacity()) * sizeof(Point); }

 private:
  double nearest_time(const Positions& positions) const;
  std::optional<double> stray(const Positions& positions, double t, double most) const;

  std::span<const Index> vertices_;
  std::vector<Point> from_, to_;  ///< by vertex
};

}  // namespace tamis
