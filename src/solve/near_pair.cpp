#include "solve/near_pair.hpp"

#include <cmath>

#include "solve/exact_distance.hpp"
#include "solve/rest_distance.hpp"
#include "solve/start_distance.hpp"

namespace tamis {
namespace {

PairPose<double> pose_of(const PairMotion<double>& m) {
  return {m.e.at0, m.f.at0, m.d.at0, m.size_e, m.size_f, m.size_d, m.separation};
}

/// Bits as NearPair::corners.
std::uint8_t carriers(PairKind kind, double u, double v) {
  const auto bits = [](bool v0, bool v1, bool v2, bool v3) {
    return static_cast<std::uint8_t>(v0 | (v1 << 1) | (v2 << 2) | (v3 << 3));
  };
  switch (kind) {
    case PairKind::vertex_face:
      return bits(true, u + v<1, u> 0, v > 0);
    case PairKind::edge_edge:
      return bits(u<1, u> 0, v<1, v> 0);
    case PairKind::vertex_edge:
      return bits(true, u<1, u> 0, false);
    case PairKind::vertex_vertex:
      break;
  }
  return bits(true, true, false, false);
}

}  // namespace

bool is_near(PairKind kind, const PairPoints& points, double separation, PrecisionCount& decided_by) {
  const PairPose<double> pose = pose_of(make_motion(kind, {points.start, points.start}, separation));
  const auto rest = with_kind(kind, [&](auto k) { return rest_distance<k()>(pose); });
  if (rest.low > pose.separation || rest.is_sharp()) {
    ++decided_by.scalar;
    return !(rest.low > pose.separation);
  }
  ++decided_by.exact;
  return apart_from_start(kind, {points.start, points.start}, separation) == 0;
}

NearPair near_pair(PairKind kind, const std::array<Index, 4>& vertices, const PairPoints& points) {
  const PairMotion<double> m = make_motion(kind, {points.start, points.start}, 1);
  const auto rest = with_kind(kind, [&](auto k) { return rest_distance<k()>(pose_of(m)); });
  if (rest.is_sharp()) {
    const Vec3<double> n = unit_vector(rest.direction);
    return near_pair(kind, vertices, rest.distance / m.separation, rest.closest.u, rest.closest.v, {n.x, n.y, n.z});
  }
  const ExactDistance exact = exact_distance(kind, points);
  const Vec3<double>& n = exact.direction;
  return near_pair(kind, vertices, exact.distance, exact.u, exact.v, {n.x, n.y, n.z});
}

NearPair near_pair(PairKind kind, const std::array<Index, 4>& vertices, double distance, double u, double v,
                   const Point& along_gap) {
  NearPair pair{kind, carriers(kind, u, v), vertices, distance, u, v, {0, 0, 0}};
  if (std::isnan(along_gap[0])) return pair;
  // Edges have the gap from the first to the second.
  const double sign = kind == PairKind::edge_edge ? -1 : 1;
  for (std::size_t k = 0; k < 3; ++k) pair.direction[k] = sign * along_gap[k] + 0.0;
  return pair;
}

}  // namespace tamis
