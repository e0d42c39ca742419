// What a path says of the vertices of a pair, checked: a bound that is negative or not a number is the caller's
// mistake, and says so.
#pragma once
#include <array>

#include "numerics/interval.hpp"
#include "numerics/vec.hpp"
#include "query/pair_vertices.hpp"
#include "tamis/path.hpp"

namespace tamis {

/// Throw InvalidPath, naming vertex and time.
void check_point(Index vertex, double time, const Point& point, double error);
void check_deviation(Index vertex, double from, double to, double deviation);

/// The vertices at one time, enclosed, in the unit of a pair.
template <class T>
struct Moment {
  double time = 0;
  std::array<Vec3<BasicInterval<T>>, 4> points;
  double error = 0;  ///< the width of the widest interval
};

/// A direction along which a vertex goes straight, and one by its length, rounded up; zeros: none is known.
struct StraightDirection {
  Vec3<double> direction{0, 0, 0};
  double per_length = 0;

  bool is_known() const { return per_length > 0; }
};
using StraightDirections = std::array<StraightDirection, 4>;
inline constexpr StraightDirections kNoDirections{};

/// Asks for the vertices at a time; lengths times the power of two that brings them to the size of the pair.
class PairReader {
 public:
  /// Keeps the reference. Vertices as in Contact: those that the kind does not use are -1, and stand at the first one.
  /// The size of the pair is that at `time_of_unit`.
  PairReader(const Path& path, const PairVertices& vertices, double time_of_unit);

  double scale() const { return scale_; }
  const StraightDirections& directions() const { return directions_; }

  /// `T`: double asks points_at, DoubleDouble fine_points_at.
  template <class T>
  Moment<T> at(double time) const;
  /// Of each vertex on [from, to].
  std::array<double, 4> deviations(double from, double to) const;

 private:
  const Path& path_;
  PairVertices vertices_;
  std::size_t count_;  ///< vertices in use
  StraightDirections directions_;
  double scale_ = 1;  ///< of lengths
};

template <>
Moment<double> PairReader::at(double time) const;
template <>
Moment<DoubleDouble> PairReader::at(double time) const;

}  // namespace tamis
