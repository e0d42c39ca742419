// Where a chain of links takes a body at one time, enclosed.
#pragma once
#include "paths/rotation.hpp"
#include "tamis/rigid_path.hpp"

namespace tamis {

/// x goes to rows x + shift.
template <class T>
struct RigidTransform {
  rotation::Rows<T> rows;
  Vec3<BasicInterval<T>> shift;
};

template <class T>
Vec3<BasicInterval<T>> operator*(const rotation::Rows<T>& rows, const Vec3<BasicInterval<T>>& x) {
  return {dot(rows[0], x), dot(rows[1], x), dot(rows[2], x)};
}

template <class T>
Vec3<BasicInterval<T>> enclosed(const Point& p) {
  using I = BasicInterval<T>;
  return {I(T(p[0])), I(T(p[1])), I(T(p[2]))};
}

/// Both rounded up: |b - a|, and the larger of |a| and |b|.
inline double change(const Point& a, const Point& b) { return length_above(enclosed<double>(b) - enclosed<double>(a)); }
inline double farthest(const Point& a, const Point& b) {
  const double first = length_above(enclosed<double>(a));
  return a == b ? first : std::max(first, length_above(enclosed<double>(b)));
}

/// (1 - t) start + t end.
template <class T>
Vec3<BasicInterval<T>> linear(const Point& start, const Point& end, double time) {
  using I = BasicInterval<T>;
  if (start == end) return enclosed<T>(start);
  const I t{T(time)}, s = I(T(1)) - t;
  return s * enclosed<T>(start) + t * enclosed<T>(end);
}

template <class T>
RigidTransform<T> transform_of(const Link& link, double time) {
  return {rotation::matrix(linear<T>(link.start.rotation, link.end.rotation, time)),
          linear<T>(link.start.position, link.end.position, time)};
}

/// First `inner`, then `outer`.
template <class T>
RigidTransform<T> after(const RigidTransform<T>& outer, const RigidTransform<T>& inner) {
  RigidTransform<T> both;
  const auto& r = inner.rows;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& row = outer.rows[i];
    both.rows[i] = row.x * r[0] + row.y * r[1] + row.z * r[2];
  }
  both.shift = outer.rows * inner.shift + outer.shift;
  return both;
}

template <class T>
RigidTransform<T> transform_of(const Chain& chain, double time) {
  if (chain.empty()) return transform_of<T>(Link{}, 0);
  auto result = transform_of<T>(chain.back(), time);
  for (auto link = chain.rbegin() + 1; link != chain.rend(); ++link)
    result = after(transform_of<T>(*link, time), result);
  return result;
}

}  // namespace tamis
