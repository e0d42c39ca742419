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
/// Parts looked at for one pair. Only pairs that slide within one plane, or touch over a time, come near it.
constexpr int kMaxParts = 256;
constexpr std::size_t kMaxDepth = 64;

/// Outward rounding of lower + s (upper - lower), s in [0,1].
double to_step(const TimeInterval<double>& part, double s, double direction) {
  const double t = (1 - s) * part.t_in + s * part.t_out;
  return std::clamp(t + direction * 4 * error_bounds::unit_roundoff<double> * part.t_out, part.t_in, part.t_out);
}

/// Where to cut an undecided part: near an end at which the points are coplanar (contacts at the very start of a step
/// are common), otherwise in the middle.
double cut_at(const PairMotion<double>& m, const TimeInterval<double>& part) {
  constexpr double kNearEnd = 1.0 / 32;
  const auto k = coplanarity_polynomial(m.d, normal_polynomial(m.e, m.f));
  const double error = error_bounds::bound(error_bounds::kCoplanarityEnd, m.size_d * m.size_e * m.size_f);
  const bool touches_start = abs(k[0]) <= error, touches_end = abs(k[3]) <= error;
  const double s = touches_start == touches_end ? 0.5 : touches_start ? kNearEnd : 1 - kNearEnd;
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
  for (int looked_at = 0; !parts.empty(); ++looked_at) {
    const auto part = parts.pop();
    const auto r = restrict_to(m, part.t_in, part.t_out);
    if (Dnf::proves_free<kind>(r) || Ncf::proves_free<kind>(r)) continue;
    const auto c = find_crossing<kind>(r);
    if (c.is_free) continue;
    const double lower = to_step(part, c.lower, -1), upper = to_step(part, c.upper, 1);
    if (c.touches) {
      findings.add_contact(lower, upper);
      break;
    }
    const double cut = cut_at(r, part);
    const bool can_cut = cut > part.t_in && cut < part.t_out && part.t_out - part.t_in > kShortest &&
                         looked_at < kMaxParts && parts.has_room();
    if (c.brackets && (upper - lower <= 0x1p-30 || !can_cut))
      findings.add_unsure(lower, upper);
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
