// The point of the difference polygon nearest to the origin: in integers, or in estimates, as long as they know every
// sign that is needed.
#pragma once
#include <array>
#include <type_traits>
#include <utility>

#include "numbers/assert.hpp"
#include "numbers/wide_double.hpp"
#include "pair/exact/moving_polygon.hpp"

namespace tamis {

/// above / below. REQUIRES of whoever reads its value: below > 0.
template <class Number>
struct Fraction {
  Number above, below{1};
};

/// The value, off by at most 2^-51 of itself. REQUIRES: below > 0.
inline WideDouble wide(const Fraction<Integer>& a) {
  TAMIS_ASSERT(a.below.sign() > 0);
  return WideDouble::of(a.above) / WideDouble::of(a.below);
}

template <class Number>
struct NearestPoint {
  struct Plane {
    Vec3<Number> normal;
    Number square;  ///< of the normal
    Number height;  ///< of the plane along the normal, times the normal's length; only if is_inside
    /// For each side: the share of the polygon's parallelogram between the side and the foot of the perpendicular,
    /// times the normal's square. Negative where the foot is beyond the side.
    std::array<Number, 4> within;
  };

  Fraction<Number> square;  ///< of the distance, in the unit 4^exponent of the polygon
  std::size_t side = 0;     ///< unless is_inside: the point is on the side from corner `side` to the next, at `along`
  Fraction<Number> along;
  bool is_inside = false;
  Plane plane;
  bool is_sure = true;  ///< false: an estimate's sign was not known, and the rest means nothing
};

template <class Number>
bool has_sign(const Number& x) {
  if constexpr (std::is_same_v<Number, Estimate>)
    return x.has_sign();
  else
    return true;
}

/// Takes the foot of the perpendicular if it lies inside, else the nearest point on the sides that part the two. In any
/// case a side that holds the origin. No other side is nearer. From the nearest point of a convex polygon the foot lies
/// along the outward normal of a side, or between the normals of two sides that meet. So it is beyond one of them.
template <class Number>
class NearestPointSearch {
  using Vector = Vec3<Number>;

 public:
  static NearestPoint<Number> in(const Polygon<Number>& polygon) { return NearestPointSearch(polygon).find(); }

  /// The normal of the polygon's plane; zero if it has none.
  static Vector normal(const Polygon<Number>& polygon) {
    if (polygon.corner_count < 3) return {};
    const Vector& first = polygon.corner(0);
    return cross(polygon.corner(1) - first, polygon.corner(polygon.corner_count - 1) - first);
  }

 private:
  struct OnSide {
    Fraction<Number> square, along;
  };

  explicit NearestPointSearch(const Polygon<Number>& polygon) : polygon_(polygon) {}

  const Vector& corner(std::size_t i) const { return polygon_.corner(i); }

  int sign(const Number& x) {
    found_.is_sure = found_.is_sure && has_sign(x);
    return x.sign();
  }

  /// The nearest point of the segment from corner x to corner y; `across` is x cross y.
  OnSide nearest_on_side(const Vector& x, const Vector& y, const Vector& across) {
    const Vector side = y - x;
    const Number before = dot(x, side);
    if (sign(before) >= 0) return {{dot(x, x)}, {0}};
    const Number length2 = dot(side, side);
    if (sign(before + length2) <= 0) return {{dot(y, y)}, {1}};  // y.side
    return {{dot(across, across), length2}, {-before, length2}};
  }

  NearestPoint<Number> find() {
    auto& plane = found_.plane;
    plane.normal = normal(polygon_);
    plane.square = dot(plane.normal, plane.normal);
    bool is_first = true, is_inside = sign(plane.square) > 0;
    for (std::size_t i = 0; i < polygon_.side_count() && found_.is_sure; ++i) {
      const Vector across = cross(corner(i), corner(i + 1));
      plane.within[i] = dot(plane.normal, across);
      const int side = sign(plane.within[i]);
      if (side > 0) continue;
      is_inside = is_inside && side == 0;
      auto [square, along] = nearest_on_side(corner(i), corner(i + 1), across);
      if (!is_first && sign(square.above * found_.square.below - found_.square.above * square.below) >= 0) continue;
      is_first = false;
      found_.square = std::move(square);
      found_.along = std::move(along);
      found_.side = i;
      if (sign(found_.square.above) == 0) return found_;
    }
    found_.is_inside = is_inside;
    if (!is_inside) return found_;
    plane.height = dot(plane.normal, corner(0));
    found_.square = {plane.height * plane.height, plane.square};
    return found_;
  }

  const Polygon<Number>& polygon_;
  NearestPoint<Number> found_;
};

}  // namespace tamis
