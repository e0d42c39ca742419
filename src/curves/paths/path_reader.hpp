// Reads the vertices of a pair from its path, and checks the path's answers. A bound that is negative or not a number
// is the caller's mistake, and throws InvalidPath.
#pragma once
#include <array>

#include "numbers/interval.hpp"
#include "numbers/vec.hpp"
#include "search/query/pair_vertices.hpp"
#include "tamis/path.hpp"

namespace tamis {

/// Throw InvalidPath, naming vertex and time, unless the point is finite and the error, or the deviation, is >= 0.
void check_point(Index vertex, double time, const Point& point, double error);
void check_deviation(Index vertex, double from, double to, double deviation);

/// The vertices of a pair at one time, enclosed in intervals and scaled (PairReader::scale).
template <class T>
struct Moment {
  double time = 0;
  std::array<Vec3<BasicInterval<T>>, 4> points;
  double error = 0;  ///< the width of the widest interval
};

/// The middles of the intervals at two moments. They are finite even where an error is not.
PairPoints points_between(const Moment<double>& from, const Moment<double>& to);

/// Takes two points, one of each feature. Bounds the difference between their distance and the distance of their
/// intervals' middles: sqrt(3) half widths for each point, doubled because middles are rounded. `error`: Moment::error.
inline double position_slack(double error) { return 4 * error + 0x1p-999; }

/// A direction along which a vertex goes straight, and 1 / its length, rounded up. Zeros if none is known.
struct StraightDirection {
  Vec3<double> direction{0, 0, 0};
  double per_length = 0;

  bool is_known() const { return per_length > 0; }
};
using StraightDirections = std::array<StraightDirection, 4>;
inline constexpr StraightDirections kNoDirections{};

/// Reads the vertices at a time, with all lengths multiplied by the power of two that brings the pair's size below 1.
class PairReader {
 public:
  /// Keeps the reference. Vertices as in Contact. Vertices that the kind does not use are -1, and get the position of
  /// the first. The power of two comes from the pair's size at `time_of_unit`.
  PairReader(const Path& path, const PairVertices& vertices, double time_of_unit);

  double scale() const { return scale_; }
  const StraightDirections& directions() const { return directions_; }

  /// Calls the path's points_at for T = double, fine_points_at for DoubleDouble.
  template <class T>
  Moment<T> at(double time) const;
  /// The deviations of each vertex on [from, to], scaled.
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
