#include "pair/exact/exact_distance.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>

#include "numbers/unit_vector.hpp"
#include "pair/exact/nearest_point.hpp"

namespace tamis {
namespace {

Vec3<double> unit_vector_of(const Vec3<Integer>& v) {
  const WideDouble x = WideDouble::of(v.x), y = WideDouble::of(v.y), z = WideDouble::of(v.z);
  const int largest = std::max({x.exponent, y.exponent, z.exponent});  // positive, but 0 if all are zero
  if (largest == 0) return {0, 0, 0};
  const auto value = [&](const WideDouble& a) { return a.times_two_to(-largest).value(); };
  return unit_vector(Vec3<double>{value(x), value(y), value(z)});
}

struct Weights {
  double u, v;
};

/// The weights of the two points whose difference is corner i of the polygon.
Weights corner_weights(PairKind kind, std::size_t i) {
  constexpr Weights kFace[] = {{0, 0}, {1, 0}, {0, 1}}, kEdges[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  return kind == PairKind::edge_edge ? kEdges[i] : kFace[i];
}

/// Rounds the nearest point that NearestPointSearch finds. Estimates must be sharp for that.
template <class Number>
class Description {
  using Vector = Vec3<Number>;

 public:
  /// `polygon`: at the time in question; `points`: the motion, which gives the direction where the gap is zero.
  Description(PairKind kind, const Polygon<Number>& polygon, const PairPoints& points)
      : kind_(kind),
        polygon_(polygon),
        points_(points),
        nearest_(NearestPointSearch<Number>::in(polygon)),
        is_sure_(nearest_.is_sure) {}

  ExactDistance made() {
    ExactDistance result = nearest_.is_inside ? inside() : on_side();
    if (sign(nearest_.square.above) > 0) result.distance = root(nearest_.square);
    return result;
  }
  /// True if the result of made() is sure and sharp. Always true of integers.
  bool is_sure() const { return is_sure_; }

 private:
  static constexpr bool kIsInteger = std::is_same_v<Number, Integer>;

  const Vector& corner(std::size_t i) const { return polygon_.corner(i); }
  /// Of corner i. Called only where the gap is zero.
  const Vector& velocity(std::size_t i) {
    if (!velocities_) velocities_ = corner_velocities<Number>(kind_, points_);
    return velocities_->corner(i);
  }

  int sign(const Number& x) {
    is_sure_ = is_sure_ && has_sign(x);
    return x.sign();
  }

  double root(const Fraction<Number>& square) {
    if constexpr (kIsInteger)
      return wide(square).root().times_two_to(polygon_.exponent).value();
    else
      return std::ldexp(std::sqrt(quotient(square)), polygon_.exponent);
  }

  double quotient(const Fraction<Number>& a) {
    if constexpr (kIsInteger) {
      return wide(a).value();
    } else {
      is_sure_ = is_sure_ && a.above.is_sharp() && a.below.is_sharp();
      return a.above.value() / a.below.value();
    }
  }

  Vec3<double> unit(const Vector& v) {
    if constexpr (kIsInteger) {
      return unit_vector_of(v);
    } else {
      const Vec3<double> rounded{v.x.value(), v.y.value(), v.z.value()};
      const double size = largest_component(rounded);
      is_sure_ = is_sure_ && v.x.is_sharp(size) && v.y.is_sharp(size) && v.z.is_sharp(size);
      return size > 0 ? unit_vector(rounded) : rounded;
    }
  }

  /// along.below times the point that lies at the fraction `along` of the way from i to j.
  static Vector at_weight(const Vector& i, const Vector& j, const Fraction<Number>& along) {
    return along.below * i + along.above * (j - i);
  }

  /// The gap's direction. If the gap is zero: the direction of its vanishing, against its velocity, less the part along
  /// the side. (At a corner the whole velocity counts.)
  Vec3<double> direction_on_side() {
    const std::size_t i = nearest_.side, j = i + 1;
    const Fraction<Number>& along = nearest_.along;
    if (sign(nearest_.square.above) > 0) return unit(at_weight(corner(i), corner(j), along));
    const Vector came = -at_weight(velocity(i), velocity(j), along);
    const bool is_corner = sign(along.above) == 0 || sign(along.below - along.above) == 0;
    if (is_corner) return unit(came);
    const Vector side = corner(j) - corner(i);
    return unit(dot(side, side) * came - dot(came, side) * side);
  }

  ExactDistance on_side() {
    const std::size_t i = nearest_.side, j = (i + 1) % polygon_.corner_count;
    const double s = quotient(nearest_.along);
    const Weights a = corner_weights(kind_, i), b = corner_weights(kind_, j);
    const auto mixed = [&](double from, double to) { return from == to ? from : to > from ? s : 1 - s; };
    return {0, mixed(a.u, b.u), mixed(a.v, b.v), direction_on_side()};
  }

  ExactDistance inside() {
    const std::size_t end = polygon_.corner_count - 1;
    const auto& plane = nearest_.plane;
    const Number &square = plane.square, &u = plane.within[end], &v = plane.within[0];
    const auto height_of_velocity = [&] {
      const Vector v0 = velocity(0);
      return dot(plane.normal, square * v0 + u * (velocity(1) - v0) + v * (velocity(end) - v0));
    };
    const int height = sign(plane.height);
    const bool is_behind = height != 0 ? height < 0 : sign(height_of_velocity()) > 0;
    const Vec3<double> direction = unit(plane.normal);
    return {0, quotient({u, square}), quotient({v, square}), is_behind ? -direction : direction};
  }

  PairKind kind_;
  const Polygon<Number>& polygon_;
  const PairPoints& points_;
  std::optional<Polygon<Number>> velocities_;
  NearestPoint<Number> nearest_;
  bool is_sure_;
};

}  // namespace

std::optional<ExactDistance> estimated_distance(PairKind kind, const PairPoints& points) {
  const auto polygon = start_polygon<Estimate>(kind, points);
  Description<Estimate> description(kind, polygon, points);
  const ExactDistance made = description.made();
  return description.is_sure() ? std::optional(made) : std::nullopt;
}

ExactDistance distance_in_integers(PairKind kind, const PairPoints& points, double time) {
  const auto polygon =
      time > 0 ? polygon_at(difference_polygon(kind, points), shortest_cell_at(time)) : start_polygon(kind, points);
  return Description<Integer>(kind, polygon, points).made();
}

ExactDistance exact_distance(PairKind kind, const PairPoints& points, double time) {
  TAMIS_ASSERT(is_finite(points) && 0 <= time && time <= 1);
  const auto estimated = time == 0 ? estimated_distance(kind, points) : std::nullopt;
  return estimated ? *estimated : distance_in_integers(kind, points, time);
}

Vec3<double> exact_normal(PairKind kind, const PairPoints& points, double time) {
  TAMIS_ASSERT(is_finite(points) && 0 <= time && time <= 1);
  const Polygon<Integer> polygon = polygon_at(difference_polygon(kind, points), shortest_cell_at(time));
  const Vec3<double> normal = unit_vector_of(NearestPointSearch<Integer>::normal(polygon));
  return kind == PairKind::edge_edge ? -normal : normal;  // the polygon's sides are -e and f
}

}  // namespace tamis
