#include "pair/narrow/near_pair.hpp"

#include "numbers/assert.hpp"
#include "pair/distance/rest_distance.hpp"
#include "pair/exact/exact_distance.hpp"
#include "pair/exact/start_distance.hpp"

namespace tamis {
namespace {

template <PairKind kind>
RestDistance<double> distance_at_start(const PairMotion<double>& m) {
  return rest_distance<kind>(m.e.at0, m.f.at0, m.d.at0, m.size_d + m.size_e + m.size_f);
}

/// The NearPair of a known distance; `unit` as for near_direction.
template <PairKind kind>
NearPair described(const std::array<Index, 4>& vertices, double distance, double u, double v,
                   const Vec3<double>& unit) {
  const Vec3<double> direction = near_direction<kind>(unit);
  return {kind, vertices, distance, u, v, {direction.x, direction.y, direction.z}};
}

}  // namespace

bool may_start_within(PairKind kind, const PairPoints& points, double separation, PrecisionCount& decided_by) {
  TAMIS_ASSERT(is_finite(points));
  const PairMotion<double> m = make_motion(kind, {points.start, points.start}, separation);
  const auto rest = with_kind(kind, [&](auto k) { return distance_at_start<k()>(m); });
  if (rest.low > m.separation || rest.is_sharp()) {
    ++decided_by.scalar;
    return !(rest.low > m.separation);
  }
  ++decided_by.exact;
  return starts_within(kind, points, separation);
}

NearPair near_pair(PairKind kind, const std::array<Index, 4>& vertices, const PairPoints& points) {
  TAMIS_ASSERT(is_finite(points));
  const PairMotion<double> m = make_motion(kind, {points.start, points.start}, 1);
  return with_kind(kind, [&](auto k) {
    const auto rest = distance_at_start<k()>(m);
    if (rest.is_sharp())
      return described<k()>(vertices, rest.distance / m.separation, rest.closest.u, rest.closest.v,
                            unit_vector(rest.direction));
    const ExactDistance exact = exact_distance(kind, points);
    return described<k()>(vertices, exact.distance, exact.u, exact.v, exact.direction);
  });
}

}  // namespace tamis
