#include "oracle/somewhere.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace tamis::oracle {
namespace {

/// p, q, and then always the negated remainder of the last two, until that is zero. Drops positive factors.
std::vector<Polynomial> signed_remainders(Polynomial p, Polynomial q) {
  std::vector<Polynomial> sequence{std::move(p)};
  while (!q.is_zero()) {
    Polynomial next = -remainder(sequence.back(), q).primitive();
    sequence.push_back(std::move(q));
    q = std::move(next);
  }
  return sequence;
}

int sign_changes(const std::vector<Polynomial>& sequence, const Rational& t) {
  int last = 0, count = 0;
  for (const Polynomial& p : sequence) {
    const int sign = p.sign_at(t);
    if (sign == 0) continue;
    if (sign == -last) ++count;
    last = sign;
  }
  return count;
}

/// (number of roots of p in (0,1) with q > 0) - (number with q < 0), each root once.
/// REQUIRES: p is not zero, and has no root at 0 or 1.
int tarski_query(const Polynomial& p, const Polynomial& q) {
  const auto sequence = signed_remainders(p, remainder(p.derivative() * q, p).primitive());
  return sign_changes(sequence, 0) - sign_changes(sequence, 1);
}

/// With s the sign of q at a root, [q > 0] = (s + s^2) / 2 and [q >= 0] = (2 + s - s^2) / 2. The product of these over
/// all conditions, summed over the roots, is a sum of Tarski queries of products of the q. Returns 2^(number of
/// conditions) times the number of roots at which all conditions hold.
int weighted_queries(const Polynomial& p, std::span<const Condition> conditions, const Polynomial& q) {
  if (conditions.empty()) return tarski_query(p, q);
  const auto rest = [&](const Polynomial& factor) {
    return weighted_queries(p, conditions.subspan(1), remainder(q * factor, p).primitive());
  };
  const Polynomial& factor = conditions[0].p;
  const int once = rest(factor), twice = rest(factor * factor);
  return conditions[0].relation == Relation::positive ? once + twice : 2 * rest(Polynomial({1})) + once - twice;
}

const Polynomial& one() {
  static const Polynomial kOne({1});
  return kOne;
}

}  // namespace

int count_roots(const Polynomial& p) { return tarski_query(p, one()); }

bool holds_at_counted_root(const Polynomial& p, std::span<const Condition> conditions) {
  if (p.degree() == 0) return false;
  // Adds one condition after the other: most questions end early.
  for (std::size_t count = 0; count <= conditions.size(); ++count)
    if (weighted_queries(p, conditions.first(count), one()) == 0) return false;
  return true;
}

namespace {

bool always_holds(const Condition& c) {
  const Signs signs = c.p.signs_on_unit_interval();
  return c.relation == Relation::positive ? !signs.zero && !signs.negative : !signs.negative;
}

bool never_holds(const Condition& c) {
  const Signs signs = c.p.signs_on_unit_interval();
  return c.relation == Relation::positive ? !signs.positive : !signs.zero && !signs.positive;
}

bool holds_at(const Rational& t, const std::vector<Condition>& conditions) {
  return std::all_of(conditions.begin(), conditions.end(), [&](const Condition& c) {
    const int sign = c.p.sign_at(t);
    return c.relation == Relation::positive ? sign > 0 : sign >= 0;
  });
}

/// If [0,1] holds one simple root of p, narrows a part of [0,1] around it until all conditions are plainly true there
/// or one is plainly false. Returns nothing if that takes too long, as when a condition vanishes at the root, too.
std::optional<bool> holds_about_root(Polynomial p, std::vector<Condition> conditions) {
  constexpr unsigned kBits = 40;
  for (int round = 0; round < 3; ++round) {
    if (!p.changes_sign_once()) return std::nullopt;
    const Integer n(std::floor(std::ldexp(p.approximate_root(), kBits)));
    p = p.on_part(n, kBits);
    for (Condition& c : conditions) c.p = c.p.on_part(n, kBits);
    for (const int end : {0, 1})
      if (p.sign_at(end) == 0) return holds_at(end, conditions);
    if (p.sign_at(0) == p.sign_at(1)) return std::nullopt;  // the approximation missed the root
    if (std::any_of(conditions.begin(), conditions.end(), never_holds)) return false;
    if (std::all_of(conditions.begin(), conditions.end(), always_holds)) return true;
  }
  return std::nullopt;
}

bool holds_at_inner_root(const Polynomial& zero, const std::vector<Condition>& conditions) {
  const Polynomial p = zero.primitive().without_roots_at_ends();
  if (const auto holds = holds_about_root(p, conditions)) return *holds;
  return holds_at_counted_root(p, conditions);
}

/// Cuts [0,1] into parts with at most one root of a polynomial each, and none in the first and the last part. So the
/// cuts have a point between any two neighbours among 0, the roots and 1.
class Cuts {
 public:
  /// REQUIRES: p is not zero, and has no root at 0 or 1.
  explicit Cuts(const Polynomial& p) : p_(p), sturm_(signed_remainders(p, p.derivative())) {
    cut(0, 1, sign_changes(sturm_, 0), sign_changes(sturm_, 1));
  }
  const std::vector<Rational>& times() const { return times_; }

 private:
  void cut(const Rational& from, const Rational& to, int changes_from, int changes_to) {
    const bool is_border = from == 0 || to == 1, is_whole = from == 0 && to == 1;
    if (changes_from - changes_to <= (is_border ? 0 : 1) && !is_whole) return;
    Rational middle = (from + to) / 2;
    while (p_.sign_at(middle) == 0) middle = (from + middle) / 2;
    times_.push_back(middle);
    const int changes = sign_changes(sturm_, middle);
    cut(from, middle, changes_from, changes);
    cut(middle, to, changes, changes_to);
  }

  const Polynomial& p_;
  std::vector<Polynomial> sturm_;
  std::vector<Rational> times_;
};

/// Decides conditions without an equation. All signs are constant between the roots of the conditions' polynomials: so
/// tries a point between each two of the roots and, for conditions that allow zero, the roots themselves.
bool holds_inside(std::vector<Condition> conditions) {
  Polynomial product({1});
  for (const Condition& c : conditions) {
    if (c.p.is_zero() && c.relation == Relation::positive) return false;
    if (!c.p.is_zero()) product = product * c.p;
  }
  std::erase_if(conditions, [](const Condition& c) { return c.p.is_zero(); });
  const Polynomial inner = product.primitive().without_roots_at_ends();
  const auto holds = [&](const Rational& t) { return holds_at(t, conditions); };
  const Cuts cuts(inner);
  if (std::any_of(cuts.times().begin(), cuts.times().end(), holds)) return true;
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    if (conditions[i].relation == Relation::positive) continue;
    std::vector<Condition> others = conditions;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    if (holds_at_inner_root(conditions[i].p, others)) return true;
  }
  return false;
}

}  // namespace

bool holds_somewhere(const Polynomial& zero, const std::vector<Condition>& conditions, Range range) {
  // Polynomials with plain signs spare most of the work.
  if (zero.never_vanishes_on_unit_interval()) return false;
  if (std::any_of(conditions.begin(), conditions.end(), never_holds)) return false;
  if (zero.sign_at(0) == 0 && holds_at(0, conditions)) return true;
  if (range == Range::closed && zero.sign_at(1) == 0 && holds_at(1, conditions)) return true;
  return zero.is_zero() ? holds_inside(conditions) : holds_at_inner_root(zero, conditions);
}

}  // namespace tamis::oracle
