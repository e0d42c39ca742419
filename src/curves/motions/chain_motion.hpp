// How a chain of links moves a body. Gives its place at a time, in doubles with error bounds, and bounds how much the
// curves of its points bend.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "curves/motions/curvature.hpp"
#include "numbers/error_bounds.hpp"
#include "numbers/finite.hpp"
#include "tamis/rigid_path.hpp"

namespace tamis {

inline bool is_finite(const Pose& pose) { return is_finite(pose.position) && is_finite(pose.rotation); }

/// A point in doubles, off by at most `error` on each axis.
struct RoundedPlace {
  Point x;
  double error;
};

/// (1 - t) a + t b. 1 - t, both products and the sum round once each: 3 u max(|a|, |b|); 4 u are given.
inline RoundedPlace rounded_linear(const Point& a, const Point& b, double time) {
  if (a == b || time == 0) return {a, 0};
  if (time == 1) return {b, 0};
  RoundedPlace place{{}, 0x1p-1000};
  const double rest = 1 - time;
  for (std::size_t k = 0; k < 3; ++k) {
    place.x[k] = rest * a[k] + time * b[k];
    place.error = std::max(place.error, 0x1p-51 * std::max(std::fabs(a[k]), std::fabs(b[k])));
  }
  return place;
}

/// |x|_1.
inline double sum_of_sizes(const Point& x) { return std::fabs(x[0]) + std::fabs(x[1]) + std::fabs(x[2]); }

/// x goes to rows x + shift, in doubles. Entries of the matrix are off by at most `turn_error`, a number. Entries of
/// the shift are at most `shift_size` and off by at most `shift_error`, lengths.
struct RoundedTransform {
  std::array<Point, 3> rows;
  Point shift;
  double turn_error, shift_error, shift_size;

  Point of(const Point& x) const {
    Point y{};
    for (std::size_t i = 0; i < 3; ++i) y[i] = rows[i][0] * x[0] + rows[i][1] * x[1] + rows[i][2] * x[2] + shift[i];
    return y;
  }
  /// What of(x) is off by on each axis, for an x that is off by `x_error`, with size = |x|_1. Each product and each sum
  /// rounds once, numbers below 1.1 |x|_1 + |shift|: 4 u of that; 8 u are given. The error of x grows at most sqrt(3)
  /// times. kRoundedUp covers the rounding of this bound itself.
  double error_of(double size, double x_error) const {
    const double turned = (turn_error + 0x1p-50) * size, shifted = shift_error + 0x1p-50 * shift_size;
    return (turned + shifted + 2 * x_error) * kRoundedUp + 0x1p-1000;
  }
};

/// Where one link takes what it carries at a time in [0,1].
RoundedTransform rounded_link(const RigidLink& link, double time);
/// The same, whose errors bound norms of the matrix and of the shift, as in chains of more links.
RoundedTransform with_norms(RoundedTransform transform);
/// The transform that applies `inner`, then `outer`. REQUIRES (not checked: history): both with_norms().
RoundedTransform after(const RoundedTransform& outer, const RoundedTransform& inner);

/// Where a chain takes a body at a time in [0,1].
RoundedTransform transform_at(const RigidChain& chain, double time);

/// Turns a direction as the chain turns the body.
Point turned_by(const RigidChain& chain, double time, const Point& direction);

inline bool operator==(const Pose& a, const Pose& b) { return a.position == b.position && a.rotation == b.rotation; }
inline bool operator==(const RigidLink& a, const RigidLink& b) { return a.start == b.start && a.end == b.end; }

/// The number of outer links that two chains share. They carry both bodies along. So the bodies move relative to each
/// other as if the chains began behind these links (docs/numerics/curves.md, "Bodies that turn together").
inline std::size_t shared_links(const RigidChain& a, const RigidChain& b) {
  std::size_t count = 0;
  while (count < a.size() && count < b.size() && a[count] == b[count]) ++count;
  return count;
}

/// A chain without its first links.
inline RigidChain without(const RigidChain& chain, std::size_t links) {
  return {chain.begin() + static_cast<std::ptrdiff_t>(links), chain.end()};
}

/// The fixed axis about which all points turn. The rotation vectors of all links from the outermost to the last that
/// turns are exactly parallel to it. Zeros if they are not parallel, or if no link turns.
Point fixed_axis(const RigidChain& chain);

/// Bounds on how a chain moves the points of a body.
class ChainBounds {
 public:
  explicit ChainBounds(const RigidChain& chain);

  /// Bounds for a point no farther than `from_origin` from the origin of its body's frame. In that frame it moves by
  /// `displacement`. Linear in `from_origin`, but for rounding.
  Curvature of(double from_origin, double displacement) const;
  /// True if any link turns. If not, points go straight.
  bool turns() const { return turns_; }

 private:
  /// Of one link: how far its rotation vector and its position change, and how far from zero the position is at most.
  struct LinkBounds {
    Interval turn, displacement, position;
  };
  std::vector<LinkBounds> links_;
  bool turns_;
};

}  // namespace tamis
