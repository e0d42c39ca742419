#include "detect/vertex_steps.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "motion/pair_kinds.hpp"
#include "numerics/interval.hpp"
#include "numerics/vec.hpp"
#include "topology/mean_edge.hpp"

namespace tamis {
namespace {

using Vec = Vec3<double>;
using IntervalVec = Vec3<Interval>;

/// Beyond the place up to which all go together no vertex goes farther than this many mean edges: pairs within reach of
/// each other would be too many.
constexpr double kFarthestInEdges = 0.25;
/// Room on either side of a plane for whoever rounds positions to doubles: of the largest coordinate.
constexpr double kPlaneRounding = 0x1p-50;

Vec vec(const double* p) { return {p[0], p[1], p[2]}; }
IntervalVec enclosed(const double* p) { return {Interval(p[0]), Interval(p[1]), Interval(p[2])}; }
double largest(const double* p) { return std::max({std::fabs(p[0]), std::fabs(p[1]), std::fabs(p[2])}); }

class PlanarTruncation {
 public:
  PlanarTruncation(const Mesh& mesh, const TogetherUntil& together)
      : step_(together.step), separations_(together.separations), time_(together.time) {
    const auto count = static_cast<std::size_t>(mesh.vertex_count());
    until_.assign(count, 1);
    positions_.assign(count, {0, 0, 0});
    radii_.assign(count, 0);
    const double farthest = kFarthestInEdges * mean_edge(mesh, step_.start);
    for (const Index v : mesh.points()) begin(v, farthest);
  }

  /// At rest there, which pairs are within reach?
  Positions positions() const { return positions_; }
  Separations reach() const { return {separations_.fixed, radii_}; }

  /// Keeps the features of a pair on either side of a plane.
  void keep_apart(const NearPair& pair) {
    const auto& v = pair.vertices;
    const PairKind kind = pair.kind;
    const Plane plane = plane_between(pair);
    const std::size_t second = second_feature(kind), count = vertex_count(kind);
    std::array<double, 4> until{};
    bool is_proven = true;
    for (std::size_t i = 0; i < count; ++i) {
      until[i] = i < second ? stays_below(v[i], plane.normal, plane.first_level)
                            : stays_below(v[i], -plane.normal, -plane.second_level);
      is_proven &= until[i] >= time_;
    }
    for (std::size_t i = 0; i < count; ++i) {
      double& own = until_[static_cast<std::size_t>(v[i])];
      own = std::min(own, is_proven ? until[i] : time_);
    }
  }

  std::vector<double> take() { return std::move(until_); }

 private:
  /// The first feature below one level along the normal, the second above the other.
  struct Plane {
    Vec normal;
    double first_level, second_level;
  };

  Vec placed(Index v) const { return vec(positions_[static_cast<std::size_t>(v)].data()); }
  Vec displacement(Index v) const { return vec(step_.end[v]) - vec(step_.start[v]); }

  void begin(Index index, double farthest) {
    const auto v = static_cast<std::size_t>(index);
    const IntervalVec way = enclosed(step_.end[index]) - enclosed(step_.start[index]);
    const double length = length_above(way);
    if (length * (1 - time_) > farthest) until_[v] = std::min(1.0, time_ + farthest / length);
    for (std::size_t k = 0; k < 3; ++k)
      positions_[v][k] = (1 - time_) * step_.start[index][k] + time_ * step_.end[index][k];
    // What is rounded here: four operations an axis, of numbers no larger than the coordinates.
    const double rounded = 0x1p-49 * std::max(largest(step_.start[index]), largest(step_.end[index]));
    const double farther = until_[v] > time_ ? (until_[v] - time_) * length : 0;  // nothing is none of infinity
    const double room = (farther + rounded) * (1 + 0x1p-40) + 0x1p-1000;
    radii_[v] = separations_.radii.empty() ? room : (room + separations_.radii[v]) * (1 + 0x1p-50);
  }

  /// Across the gap of the closest points; where in it, by the speeds at which the two features come nearer. Rounded:
  /// proven by stays_below.
  Plane plane_between(const NearPair& pair) const {
    constexpr double kLeastPart = 0.125;
    const auto& [kind, v] = std::tie(pair.kind, pair.vertices);
    const Vec n = -vec(pair.direction.data());
    if (!(dot(n, n) > 0)) return {{0, 0, 0}, 0, 0};
    double below = -HUGE_VAL, above = HUGE_VAL, first_speed = 0, second_speed = 0;
    for (std::size_t i = 0; i < vertex_count(kind); ++i) {
      const double place = dot(n, placed(v[i])), speed = dot(n, displacement(v[i]));
      if (i < second_feature(kind)) {
        below = std::max(below, place);
        first_speed = std::max(first_speed, speed);
      } else {
        above = std::min(above, place);
        second_speed = std::max(second_speed, -speed);
      }
    }
    const double separation = separations_.between(kind, v) * (1 + 0x1p-40);
    const double room = above - below - separation, speeds = first_speed + second_speed;
    const double part = speeds > 0 ? std::clamp(first_speed / speeds, kLeastPart, 1 - kLeastPart) : 0.5;
    const double level = below + part * room;
    return {n, level, level + separation};
  }

  /// The last time, at most the vertex' own, until which it is proven to stay below the level along n, with room for
  /// rounding; below time_ if it is not even there then.
  double stays_below(Index index, const Vec& n, double level) const {
    const IntervalVec normal{Interval(n.x), Interval(n.y), Interval(n.z)};
    const double size = std::max(largest(step_.start[index]), largest(step_.end[index]));
    const double own = until_[static_cast<std::size_t>(index)];
    if (is_far_below(index, n, level, size)) return own;
    // Levels of a pair lie its separation apart along n, whose length is 1 within 2^-50.
    const Interval margin(kPlaneRounding * size + 0x1p-48 * std::fabs(level) + 0x1p-1000);
    const Interval start = dot(normal, enclosed(step_.start[index]));
    const Interval speed = dot(normal, enclosed(step_.end[index]) - enclosed(step_.start[index]));
    const Interval limit = Interval(level) - margin;
    const auto is_below_at = [&](double t) { return start + Interval(t) * speed < limit; };
    if (!is_below_at(time_)) return -1;
    if (is_below_at(own)) return own;
    const double until = std::min(((limit - start) / speed).lower, own);
    return until > time_ && is_below_at(until) ? until : time_;
  }

  /// By so much that doubles prove it (docs/numerics.md, "Every vertex its own step"): of most.
  bool is_far_below(Index index, const Vec& n, double level, double size) const {
    const double own = until_[static_cast<std::size_t>(index)];
    const double start = dot(n, vec(step_.start[index])), end = dot(n, vec(step_.end[index]));
    const double limit = level - 0x1p-40 * (size + std::fabs(level)) - 0x1p-1000;
    if (!std::isfinite(start) || !std::isfinite(end)) return false;  // a sum may have overflowed on its way
    return (1 - time_) * start + time_ * end < limit && (1 - own) * start + own * end < limit;
  }

  const Step& step_;
  const Separations& separations_;
  const double time_;
  std::vector<double> until_;     ///< of each vertex
  std::vector<Point> positions_;  ///< at time_, rounded
  std::vector<double> radii_;     ///< how far it goes from there, and the caller's own
};

}  // namespace

std::vector<double> vertex_steps(const Mesh& mesh, RestEngine& engine, std::vector<NearPair>& near,
                                 const TogetherUntil& together, Statistics& statistics) {
  if (together.time >= 1) return std::vector<double>(static_cast<std::size_t>(mesh.vertex_count()), 1);
  PlanarTruncation steps(mesh, together);
  engine.find_near(steps.positions(), steps.reach(), near, statistics);
  for (const NearPair& pair : near) steps.keep_apart(pair);
  near.clear();
  return steps.take();
}

}  // namespace tamis
