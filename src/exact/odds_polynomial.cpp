#include "exact/odds_polynomial.hpp"

#include <algorithm>
#include <climits>
#include <cmath>

#include "numerics/assert.hpp"
#include "numerics/error_bounds.hpp"

namespace tamis {
namespace {

/// Above the exponent of any root: no memory holds integers of so many bits.
constexpr long kUnbounded = 1L << 40;

}  // namespace

OddsPolynomial::OddsPolynomial(const IntegerPolynomial& p) : first_(p.degree()) {
  TAMIS_ASSERT(!p.is_zero());
  const auto bernstein = p.bernstein();
  for (int i = 0; i <= p.degree(); ++i) {
    const Integer& b = bernstein[static_cast<std::size_t>(i)];
    if (b.sign() == 0) continue;
    coefficients_[static_cast<std::size_t>(i)] = WideDouble::of(b);
    first_ = std::min(first_, i);
    last_ = i;
  }
}

int OddsPolynomial::sign_between(const Odds& low, const Odds& high) const {
  std::array<WideDouble, IntegerPolynomial::kMaxDegree + 1> least{}, most{};
  double power_low = 1, power_high = 1;
  long highest = LONG_MIN;
  for (int i = 0; i <= last_; ++i, power_low *= low.mantissa, power_high *= high.mantissa) {
    const WideDouble& c = at(i);
    if (c.sign() == 0) continue;
    const auto k = static_cast<std::size_t>(i);
    least[k] = {c.mantissa * power_low, c.exponent + low.exponent * i};
    most[k] = {c.mantissa * power_high, c.exponent + high.exponent * i};
    if (c.sign() < 0) std::swap(least[k], most[k]);
    highest = std::max({highest, least[k].exponent, most[k].exponent});
  }
  double lower = 0, upper = 0, size = 0;
  for (std::size_t i = 0; i < least.size(); ++i) {
    const double from = times_power_of_two(least[i].mantissa, least[i].exponent - highest);
    const double to = times_power_of_two(most[i].mantissa, most[i].exponent - highest);
    lower += from;
    upper += to;
    size += std::max(std::fabs(from), std::fabs(to));
  }
  const double error = error_bounds::bound(error_bounds::kOddsPolynomial, size);
  return lower > error ? 1 : upper < -error ? -1 : 0;
}

double OddsPolynomial::meeting(int i, int j) const {
  return static_cast<double>(at(i).exponent - at(j).exponent) / (j - i);
}

int OddsPolynomial::next_corner(int i) const {
  TAMIS_ASSERT(i < last_);
  int next = last_;
  for (int j = last_ - 1; j > i; --j)
    if (at(j).sign() != 0 && meeting(i, j) < meeting(i, next)) next = j;
  return next;
}

bool OddsPolynomial::rules(int i, long low, long high) const {
  double others = 0;
  for (int k = 0; k <= last_; ++k)
    if (at(k).sign() == -at(i).sign())
      others += times_power_of_two(std::fabs(at(k).mantissa / at(i).mantissa),
                                   at(k).exponent - at(i).exponent + (k - i) * (k > i ? high : low));
  return low <= high && others <= 0.5;
}

OddsPolynomial OddsPolynomial::slope_over_power(int i) const {
  OddsPolynomial slope = *this;
  for (int k = 0; k <= last_; ++k) slope.coefficients_[static_cast<std::size_t>(k)].mantissa *= k - i;
  return slope;
}

bool OddsPolynomial::find_roots(std::vector<OddsBracket>& roots) const {
  constexpr long kRoom = 3;
  long ruled_from = -kUnbounded;
  int corner = first_;
  while (corner < last_) {
    const int next = next_corner(corner);
    const auto meet = static_cast<long>(std::floor(meeting(corner, next)));
    const bool crosses = at(corner).sign() != at(next).sign();
    const long before = crosses ? meet - kRoom : meet, after = crosses ? meet + kRoom : meet;
    if (!rules(corner, ruled_from, before)) return false;
    if (crosses) {
      if (!slope_over_power(corner).rules(next, before, after)) return false;
      roots.push_back(narrowed({{0.5, before + 1}, {0.5, after + 1}, at(corner).sign()}));
    }
    corner = next;
    ruled_from = after;
  }
  return rules(corner, ruled_from, kUnbounded);
}

OddsBracket OddsPolynomial::narrowed(OddsBracket bracket) const {
  auto& [low, high, sign_before] = bracket;
  constexpr double kWidth = 0x1p-32;
  while (true) {
    if (high.exponent == low.exponent + 1) high = {2 * high.mantissa, low.exponent};
    const bool is_near = high.exponent == low.exponent;
    if (is_near && high.mantissa - low.mantissa < kWidth) return bracket;
    const Odds middle = is_near ? Odds{0.5 * (low.mantissa + high.mantissa), low.exponent}
                                : Odds{0.5, (low.exponent + high.exponent) / 2};
    const int sign = sign_between(middle, middle);
    if (sign == 0) return bracket;
    (sign == sign_before ? low : high) = middle;
  }
}

}  // namespace tamis
