// Where a chain of links takes a body at one time, enclosed in double-double.
#pragma once
#include "curves/motions/fine_point.hpp"
#include "curves/motions/rotation.hpp"
#include "tamis/rigid_path.hpp"

namespace tamis {

/// x goes to rows x + shift.
struct RigidTransform {
  rotation::Rows rows;
  Vec3<FineInterval> shift;
};

inline Vec3<FineInterval> operator*(const rotation::Rows& rows, const Vec3<FineInterval>& x) {
  return {dot(rows[0], x), dot(rows[1], x), dot(rows[2], x)};
}

/// Both rounded up: |b - a|, and the larger of |a| and |b|.
inline double change(const Point& a, const Point& b) { return length_above(enclosed<double>(b) - enclosed<double>(a)); }
inline double farthest(const Point& a, const Point& b) {
  const double first = length_above(enclosed<double>(a));
  return a == b ? first : std::max(first, length_above(enclosed<double>(b)));
}

/// (1 - t) start + t end.
inline Vec3<FineInterval> linear(const Point& start, const Point& end, double time) {
  using I = FineInterval;
  if (start == end) return enclosed<DoubleDouble>(start);
  const I t(time), s = I(1) - t;
  return s * enclosed<DoubleDouble>(start) + t * enclosed<DoubleDouble>(end);
}

inline RigidTransform transform_of(const RigidLink& link, double time) {
  return {rotation::matrix(linear(link.start.rotation, link.end.rotation, time)),
          linear(link.start.position, link.end.position, time)};
}

/// The transform that applies `inner`, then `outer`.
inline RigidTransform after(const RigidTransform& outer, const RigidTransform& inner) {
  RigidTransform both;
  const auto& r = inner.rows;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& row = outer.rows[i];
    both.rows[i] = row.x * r[0] + row.y * r[1] + row.z * r[2];
  }
  both.shift = outer.rows * inner.shift + outer.shift;
  return both;
}

inline RigidTransform transform_of(const RigidChain& chain, double time) {
  if (chain.empty()) return transform_of(RigidLink{}, 0);
  auto result = transform_of(chain.back(), time);
  for (auto link = chain.rbegin() + 1; link != chain.rend(); ++link) result = after(transform_of(*link, time), result);
  return result;
}

}  // namespace tamis
