#include "integrations/followers.hpp"

#include <algorithm>
#include <cmath>

namespace tamis::adapters {
namespace {

/// In radians: a body that turns by more than this comes to another place than its velocity says, and stands for
/// nothing if it is held back there.
constexpr double kSmallTurn = 0.3;
/// Sweeps over all approaches; more sweeps would only save questions.
constexpr int kMostSweeps = 32;

/// How a body's whole way moves its points.
class WholeWay {
 public:
  WholeWay(const WantedStep& step, BodyId body)
      : start_(step.pose(body, 0)),
        end_(step.pose(body, 1)),
        from_(rotation_matrix(start_.rotation)),
        to_(rotation_matrix(end_.rotation)) {}

  /// True if points go nearly straight.
  bool is_nearly_straight() const {
    double trace = 0;  // of the turn's matrix: 1 + 2 cos(angle)
    for (std::size_t i = 0; i < 3; ++i) trace += dot(from_[i], to_[i]);
    return trace > 1 + 2 * std::cos(kSmallTurn);
  }
  Point of(const Point& p) const {
    const Point local = times_transposed(from_, minus(p, start_.position));
    return minus(plus(times(to_, local), end_.position), p);
  }

 private:
  Pose start_, end_;
  Matrix from_, to_;
};

}  // namespace

Followers::Followers(const Near& near, const WantedStep& step, double gap, Fractions& fractions) : gap_(gap) {
  std::map<BodyId, WholeWay> ways;
  for (const BodyId body : step.moving()) ways.emplace(body, WholeWay(step, body));
  const auto turns = [&](BodyId body) {
    const auto way = ways.find(body);
    return way != ways.end() && !way->second.is_nearly_straight();
  };
  for (const auto& [bodies, found] : near)
    for (const NearContact& contact : found.contacts) {
      if (!(contact.distance() > 0) || turns(bodies[0]) || turns(bodies[1])) continue;
      Approach& approach = approaches_.emplace_back(Approach{bodies, contact.distance(), {0, 0}, {nullptr, nullptr}});
      for (const std::size_t k : {0U, 1U})
        if (const auto way = ways.find(bodies[k]); way != ways.end()) {
          const double parting = dot(way->second.of(contact.points[k]), contact.normal);
          approach.closing[k] = k == 0 ? -parting : parting;
          approach.fractions[k] = &fractions.at(bodies[k]);
        }
    }
}

/// Sweeps forwards and backwards through the approaches, as followers have followers.
std::set<BodyId> Followers::hold_back() {
  std::set<BodyId> slower;
  bool changes = true;
  for (int sweep = 0; changes && sweep < kMostSweeps; ++sweep) {
    changes = false;
    for (const Approach& approach : approaches_) changes |= hold_back_at(approach, slower);
    std::ranges::reverse(approaches_);
  }
  return slower;
}

bool Followers::hold_back_at(const Approach& approach, std::set<BodyId>& slower) const {
  double closing = 0, parting = 0;
  for (const std::size_t i : {0U, 1U}) {
    if (!approach.fractions[i]) continue;
    const double way = *approach.fractions[i] * approach.closing[i];
    (way > 0 ? closing : parting) += way;
  }
  const double kept = std::clamp(approach.distance / 2, kLeastDistance * gap_, gap_);
  const double allowed = std::max(0.0, approach.distance - kept) - parting;
  if (closing <= allowed * (1 + kTolerance)) return false;
  for (const std::size_t i : {0U, 1U}) {
    if (!approach.fractions[i] || approach.closing[i] <= 0) continue;
    *approach.fractions[i] *= allowed / closing;
    slower.insert(approach.bodies[i]);
  }
  return true;
}
}  // namespace tamis::adapters
