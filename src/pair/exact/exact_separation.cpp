#include "pair/exact/exact_separation.hpp"

#include <cmath>

#include "numbers/assert.hpp"

namespace tamis {
namespace {

/// A vector whose components are polynomials in time.
using PolynomialVec = Vec3<IntegerPolynomial>;

PolynomialVec vector_of(const Moving<Integer>& v) {
  const auto along = [](const Integer& at0, const Integer& at1) {
    return IntegerPolynomial::from_bernstein<2>({at0, at1});
  };
  return {along(v.at0.x, v.at1.x), along(v.at0.y, v.at1.y), along(v.at0.z, v.at1.z)};
}

class SeparationTest {
 public:
  SeparationTest(const MovingPolygon& polygon, double separation, TouchingTimes& times)
      : polygon_(polygon), times_(times) {
    const Integer s = scaled_to_integer(separation, polygon.exponent);
    square_ = s * s;
    for (std::size_t i = 0; i < polygon.corner_count; ++i) corners_[i] = vector_of(polygon.corners[i]);
  }

  void run() {
    for (std::size_t i = 0; i < polygon_.corner_count; ++i) add_corner(corner(i));
    for (std::size_t i = 0; i < polygon_.side_count(); ++i) add_side(corner(i), corner(i + 1));
    if (polygon_.corner_count > 2) add_plane();
  }

 private:
  const PolynomialVec& corner(std::size_t i) const { return corners_[i % polygon_.corner_count]; }

  void add_corner(const PolynomialVec& c) {
    times_.add_roots(dot(c, c) - IntegerPolynomial(square_), [](AlgebraicTime&) { return true; });
  }

  void add_side(const PolynomialVec& x, const PolynomialVec& y) {
    const PolynomialVec side = y - x, normal = cross(x, y);
    times_.add_roots(dot(normal, normal) - square_ * dot(side, side), [&](AlgebraicTime& time) {
      const int before = time.sign_of(dot(x, side));
      if (before > 0) return false;
      const int after = time.sign_of(dot(y, side));
      return after >= 0 && after != before;  // both zero: a side of no length
    });
  }

  void add_plane() {
    const PolynomialVec normal = cross(corner(1) - corner(0), corner(polygon_.corner_count - 1) - corner(0));
    const IntegerPolynomial height = dot(corner(0), normal);
    times_.add_roots(height * height - square_ * dot(normal, normal), [&](AlgebraicTime& time) {
      bool has_area = false;
      for (std::size_t i = 0; i < polygon_.corner_count; ++i) {
        const int side = time.sign_of(dot(normal, cross(corner(i), corner(i + 1))));
        if (side < 0) return false;
        has_area |= side > 0;
      }
      return has_area;
    });
  }

  const MovingPolygon& polygon_;
  Integer square_;  ///< of the separation
  std::array<PolynomialVec, 4> corners_;
  TouchingTimes& times_;
};

}  // namespace

void add_times_within(const MovingPolygon& polygon, double separation, TouchingTimes& times) {
  TAMIS_ASSERT(separation > 0 && std::isfinite(separation));
  SeparationTest(polygon, separation, times).run();
}

}  // namespace tamis
