#include "solve/subdivide.hpp"

#include <algorithm>
#include <array>

#include "filters/dnf.hpp"
#include "filters/ncf.hpp"
#include "solve/crossing.hpp"

namespace tamis {
namespace {

/// Shortest part that is cut further, as a fraction of the step: a contact is then known to 2^-44.
constexpr double kShortest = 0x1p-44;
/// Parts looked at for one pair.
constexpr int kMaxParts = 96;
/// Of these, parts that are coplanar throughout: cutting them helps only NCF.
constexpr int kMaxCoplanarParts = 6;
constexpr std::size_t kMaxDepth = 64;

/// How the points of a part are coplanar, as far as doubles can tell.
struct Coplanarity {
  bool at_start, at_end, always;
};

Coplanarity coplanarity(const PairMotion<double>& m) {
  const auto k = coplanarity_polynomial(m.d, normal_polynomial(m.e, m.f));
  const double unit = m.size_d * m.size_e * m.size_f;
  const double end = error_bounds::bound(error_bounds::kCoplanarityEnd, unit);
  const double middle = error_bounds::bound(error_bounds::kCoplanarityMiddle, unit);
  const bool at_start = abs(k[0]) <= end, at_end = abs(k[3]) <= end;
  return {at_start, at_end, at_start && at_end && abs(k[1]) <= middle && abs(k[2]) <= middle};
}

/// Where to cut an undecided part: near an end at which the points are coplanar (contacts at the very start of a step
/// are common), otherwise near the middle. At no simple fraction: contacts happen at those, and one at a cut is
/// undecided on both sides.
double cut_at(const Coplanarity& points, const TimeInterval<double>& part) {
  constexpr double kNearMiddle = 0.48713, kNearEnd = 0.03137;
  const double s = points.at_start == points.at_end ? kNearMiddle : points.at_start ? kNearEnd : 1 - kNearEnd;
  return (1 - s) * part.t_in + s * part.t_out;
}

/// Parts still to be looked at, the earliest on top.
class PartStack {
 public:
  explicit PartStack(const TimeInterval<double>& all) { parts_[size_++] = all; }
  bool empty() const { return size_ == 0; }
  TimeInterval<double> pop() { return parts_[--size_]; }
  bool has_room() const { return size_ + 2 <= kMaxDepth; }
  void push_halves(const TimeInterval<double>& part, double cut) {
    parts_[size_++] = {cut, part.t_out};
    parts_[size_++] = {part.t_in, cut};
  }

 private:
  std::array<TimeInterval<double>, kMaxDepth> parts_;
  std::size_t size_ = 0;
};

/// Keeps the whole answer: an undecided part before a certified one moves only the lower end.
struct Findings {
  Decision decision;
  void add_unsure(double lower, double upper) {
    if (decision.verdict == Verdict::is_free) decision = {Verdict::unsure, lower, upper};
    decision.upper = std::max(decision.upper, upper);
  }
  void add_contact(double lower, double upper) {
    const bool first = decision.verdict == Verdict::is_free;
    decision = {Verdict::touches, first ? lower : decision.lower, upper};
  }
};

template <PairKind kind>
Decision subdivide(const PairMotion<double>& m, const TimeInterval<double>& time) {
  Findings findings;
  PartStack parts(time);
  int coplanar_parts = 0;
  for (int looked_at = 0; !parts.empty(); ++looked_at) {
    const auto part = parts.pop();
    const auto r = restrict_to(m, part.t_in, part.t_out);
    if (Dnf::proves_free<kind>(r) || Ncf::proves_free<kind>(r)) continue;
    const auto c = find_crossing<kind>(m, part);
    if (c.is_free) continue;
    if (c.touches) {
      findings.add_contact(c.lower, c.upper);
      break;
    }
    const auto points = coplanarity(r);
    coplanar_parts += points.always;
    const double cut = cut_at(points, part);
    const bool can_cut = cut > part.t_in && cut < part.t_out && part.t_out - part.t_in > kShortest &&
                         looked_at < kMaxParts && coplanar_parts < kMaxCoplanarParts && parts.has_room();
    if (c.brackets && (c.upper - c.lower <= 0x1p-30 || !can_cut))
      findings.add_unsure(c.lower, c.upper);
    else if (can_cut)
      parts.push_halves(part, cut);
    else
      findings.add_unsure(part.t_in, part.t_out);
  }
  return findings.decision;
}

}  // namespace

Decision subdivide(PairKind kind, const PairMotion<double>& m, const TimeInterval<double>& time) {
  return kind == PairKind::vertex_face ? subdivide<PairKind::vertex_face>(m, time)
                                       : subdivide<PairKind::edge_edge>(m, time);
}

}  // namespace tamis
