#include <cmath>

#include "motion/pair_kinds.hpp"
#include "narrow/crossing_slope.hpp"
#include "narrow/finely.hpp"
#include "numerics/assert.hpp"

namespace tamis {
namespace {

using Fine = DoubleDouble;

/// Newton's method, from the middle of a bracket until its ends are neighbouring doubles.
class FineCrossing {
 public:
  /// `slope`: of the coplanarity during the bracket, -1 or 1.
  FineCrossing(const PairMotion<Fine>& fine, const PairMotion<double>& m, int slope)
      : fine_(fine),
        error_(error_bounds::bound<Fine>(error_bounds::kCoplanarityNow, fine.size_d * fine.size_e * fine.size_f)),
        cubic_(coplanarity_polynomial(m)),
        slope_(slope) {}

  std::optional<TimeInterval<double>> run(TimeInterval<double> bracket) const {
    constexpr int kMostLooks = 8;
    bool is_before_known = false, is_after_known = false;
    double t = bracket.t_in + 0.5 * (bracket.t_out - bracket.t_in);
    for (int looks = 0; looks < kMostLooks && t > bracket.t_in && t < bracket.t_out; ++looks) {
      const Fine value = coplanarity_at(t);
      if (!(abs(value) > error_)) break;  // the root may be this very double
      const bool is_before = (value.high > 0) != (slope_ > 0);
      (is_before ? is_before_known : is_after_known) = true;
      (is_before ? bracket.t_in : bracket.t_out) = t;
      if (is_before_known && is_after_known && std::nextafter(bracket.t_in, 2.0) == bracket.t_out) return bracket;
      const double next = t - value.high / crossing::slope(cubic_, t);
      t = next != t ? next : std::nextafter(t, is_before ? 2.0 : -1.0);
    }
    return {};
  }

 private:
  Fine coplanarity_at(double t) const {
    return dot(at_time(fine_.d, Fine(t)), cross(at_time(fine_.e, Fine(t)), at_time(fine_.f, Fine(t))));
  }

  const PairMotion<Fine>& fine_;
  const Fine error_;
  const std::array<double, 4> cubic_;
  const int slope_;
};

}  // namespace

std::optional<TimeInterval<double>> first_crossing_finely(PairKind kind, const PairPoints& points,
                                                          const PairMotion<double>& m,
                                                          const TimeInterval<double>& bracket) {
  TAMIS_ASSERT(can_cross(kind) && is_motion_of(m, kind, points));
  const int slope = crossing::slope_during(m, bracket);
  if (slope == 0) return {};
  return FineCrossing(make_fine_motion(kind, points, 0), m, slope).run(bracket);
}

}  // namespace tamis
