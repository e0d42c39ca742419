// Decides in double-double a crossing that doubles leave undecided. Either the pair is known to touch, and the time is
// sought. Or the pair passes close to a border of its features, and may touch. Exact algebra would give the same
// answer, at many times the cost.
#include <algorithm>
#include <cmath>

#include "numbers/assert.hpp"
#include "pair/motion/pair_kinds.hpp"
#include "pair/narrow/crossing_sides.hpp"
#include "pair/narrow/crossing_slope.hpp"
#include "pair/narrow/decisions.hpp"

namespace tamis {
namespace {

using Fine = DoubleDouble;

/// Where the coplanarity is zero, give or take the radius.
struct FineRoot {
  Fine time;
  double radius;
};

/// The crossing during a bracket where the slope of the coplanarity has one sign.
class FineCrossing {
 public:
  /// `slope`: the least slope of the coplanarity during the bracket, with its sign.
  FineCrossing(const PairMotion<Fine>& fine, const PairMotion<double>& m, double slope)
      : fine_(fine),
        error_(error_bounds::bound<Fine>(error_bounds::kCoplanarityNow, fine.size_d * fine.size_e * fine.size_f)),
        cubic_(coplanarity_polynomial(m)),
        slope_(slope) {}

  /// The root, by Newton's method from the middle of the bracket. Nothing if it may lie outside. A root is no farther
  /// from t than the coplanarity at t divided by the least slope.
  std::optional<FineRoot> root(const TimeInterval<double>& bracket) const {
    constexpr int kMaxIterations = 4;
    constexpr double kSharp = 0x1p-80;  // a sharper root tells the inside test no more
    FineRoot root{bracket.t_in + 0.5 * (bracket.t_out - bracket.t_in), 1};
    for (int iterations = 1;; ++iterations) {
      const Fine value = coplanarity_at(root.time);
      root.radius = kRoundedUp * (std::fabs(value.high) + 2 * error_.high) / std::fabs(slope_);
      if (!(root.radius > kSharp) || iterations == kMaxIterations) break;
      root.time = root.time - value.high / crossing::slope(cubic_, root.time.high);
    }
    const bool is_within = root.time - root.radius > bracket.t_in && Fine(bracket.t_out) - root.radius > root.time;
    return is_within ? std::optional(root) : std::nullopt;
  }

  template <PairKind kind>
  crossing::Sides<Fine> sides(const FineRoot& root) const {
    const Vec3<Fine> n = cross(at_time(fine_.e, root.time), at_time(fine_.f, root.time));
    return crossing::sides<kind>(fine_, n, root.time, Fine(2 * root.radius));  // the radius and its rounding
  }

 private:
  Fine coplanarity_at(const Fine& t) const {
    return dot(at_time(fine_.d, t), cross(at_time(fine_.e, t), at_time(fine_.f, t)));
  }

  const PairMotion<Fine>& fine_;
  const Fine error_;
  const std::array<double, 4> cubic_;
  const double slope_;
};

/// A contact between the neighbouring doubles that enclose the root strictly. Nothing if the root may be a double.
std::optional<Decision> touches_around(const FineRoot& root) {
  const double before = root.time.low > 0 ? root.time.high : std::nextafter(root.time.high, -1.0);
  const double after = std::nextafter(before, 2.0);
  if (!(root.time - before > 2 * root.radius && Fine(after) - root.time > 2 * root.radius)) return {};
  return Decision{Verdict::touches, before, after};
}

}  // namespace

std::optional<Decision> decide_crossing_finely(const PairInStep& pair, const Decision& coarse) {
  TAMIS_ASSERT(can_cross(pair.kind) && pair.separation == 0 && !coarse.is_free());
  // The clip may end at the very root.
  const double margin = coarse.touches() ? 0 : 0x1p-50;
  const TimeInterval<double> around{std::max(coarse.lower - margin, 0.0), std::min(coarse.upper + margin, 1.0)};
  const double slope = crossing::least_slope_during(pair.motion, around);
  if (slope == 0) return {};
  const PairMotion<Fine> fine = make_fine_motion(pair);
  const FineCrossing crossing(fine, pair.motion, slope);
  const auto root = crossing.root(around);
  if (!root) return {};
  if (coarse.touches()) return touches_around(*root);
  const auto sides = with_crossing_kind(pair.kind, [&](auto kind) { return crossing.sides<kind()>(*root); });
  if (sides.outside) return Decision{};
  return sides.inside ? touches_around(*root) : std::nullopt;
}

}  // namespace tamis
