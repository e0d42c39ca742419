#include "integrations/speeds.hpp"

#include <set>

namespace tamis::adapters {
namespace {

/// Rounds over the places where bodies met: each may bring bodies nearer at another one.
constexpr int kStopRounds = 10;
/// A body that goes less than this part of its way keeps so much of its speed: if it kept all, gravity would add to it
/// in each step, and where nothing else stops it it would hang there for ever. A slow body, which goes less than kSlow
/// gaps in a step, must go less: it may be about to tip over.
constexpr double kStands = 0.01, kStandsSlow = 1e-3, kKeptSpeed = 0.5, kSlow = 10;

}  // namespace

Velocities take_speeds(WantedStep& step, const Near& near, double gap) {
  Velocities kept, ways;
  for (const BodyId body : step.moving()) {
    kept[body] = step.velocity(body);
    ways[body] = step.way(body);
  }
  if (near.empty()) return kept;
  Carriers carriers(near, step, step.carried_at() * gap);
  const bool are_same = kept == ways;
  carriers.take_speed(kept);
  if (are_same)
    ways = kept;
  else
    carriers.take_speed(ways);
  carriers.part(ways);
  for (const auto& [body, way] : ways)
    if (!(way == step.way(body))) step.set_way(body, way);
  return kept;
}

void stop_where_met(std::vector<NearContact> hits, const Near& near, const WantedStep& step, Velocities& velocities) {
  std::set<BodyPair> met;
  for (const NearContact& hit : hits) met.insert(hit.bodies);
  for (const BodyPair& bodies : met) {
    const std::vector<NearContact>& places = near.at(bodies).contacts;
    hits.insert(hits.end(), places.begin(), places.end());
  }
  for (int round = 0; round < kStopRounds; ++round)
    for (const NearContact& hit : hits) Carriers::stop(hit, step, velocities);
}

BodyEnd end_of(BodyId body, const WantedStep& step, double fraction, const Velocity& velocity, double gap) {
  BodyEnd end{fraction, velocity};
  const auto& [linear, angular] = end.velocity;
  const double way = step.seconds() * (length(linear) + step.radius(body) * length(angular));
  if (end.fraction < (way < kSlow * gap ? kStandsSlow : kStands))
    end.velocity = {times(kKeptSpeed, linear), times(kKeptSpeed, angular)};
  return end;
}

}  // namespace tamis::adapters
