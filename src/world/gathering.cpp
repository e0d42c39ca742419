// What may touch in a question, found and gathered.
#include <algorithm>
#include <cmath>
#include <limits>

#include "paths/fine_point.hpp"
#include "paths/path_search.hpp"
#include "query/cancellation.hpp"
#include "topology/at.hpp"
#include "world/world_state.hpp"

namespace tamis {
namespace {

/// What is gathered is more than what may touch now, by so many mean edges: it serves the steps that follow.
constexpr double kMoreInEdges = 0.5;
/// It is gathered anew once so few of the items that it was made for may touch.
constexpr std::size_t kShrunk = 4;
constexpr double kMostPieces = 4096;

bool is_straight(const Body& a, const Body& b) {
  return a.motion_kind() != MotionKind::turning && b.motion_kind() != MotionKind::turning;
}
bool is_turning(const Body& a, const Body& b) { return !is_straight(a, b); }

}  // namespace

double World::State::Reach::own(const Body& body) const {
  const double way =
      part_of_way > 0 && body.motion_kind() != MotionKind::still ? part_of_way * body.hull().extent() : 0;
  return body.radius() + way;
}

std::vector<BodyPair> World::State::near_bodies(const Reach& reach, double more, bool at_start) {
  stop_if_cancelled(options);
  const auto own = [&](const Body& body) { return reach.own(body) * (1 + 0x1p-40); };
  std::vector<BodyPair> pairs = near_bodies_.find(bodies, own, (reach.separation + more) * (1 + 0x1p-40), at_start);
  if (!kept_apart.empty()) std::erase_if(pairs, [&](const BodyPair& pair) { return kept_apart.contains(pair); });
  return pairs;
}

std::vector<BodyPair> World::State::only(const Wanted& is_wanted, std::vector<BodyPair> pairs) const {
  std::erase_if(pairs, [&](const BodyPair& pair) { return !is_wanted(*bodies[at(pair[0])], *bodies[at(pair[1])]); });
  return pairs;
}

void World::State::gather(Gathering& gathering, const Reach& reach, const Wanted& is_wanted,
                          const std::vector<BodyPair>& near, const std::vector<double>& times) {
  const std::vector<BodyPair> wanted = only(is_wanted, near);
  if (wanted.empty()) return;
  if (gathering.serves(bodies, wanted, reach)) {
    gathering.pairs = wanted;
    return;
  }
  const auto find = [&](const std::vector<BodyPair>& pairs, double more) {
    const auto reach_of = [&](const Body& a, const Body& b) { return (reach.of(a, b) + more) * (1 + 0x1p-40); };
    return find_near_items(bodies, pairs, reach_of, times);
  };
  const NearItems needed = find(wanted, 0);
  gathering.pairs = needed.pairs;
  if (!gathering.is_asked()) return;
  const std::size_t count = needed.count();
  if (gathering.gathered && kShrunk * count >= gathering.needed_when_gathered &&
      gathering.gathered->keeps_motion_kinds(bodies) && gathering.gathered->includes(needed))
    return;
  double edges = 0;
  for (const auto& [id, unused] : needed.of_body) edges += bodies[at(id)]->shape().edge;
  const double more = kMoreInEdges * edges / static_cast<double>(needed.of_body.size());
  const std::vector<BodyPair> farther = only(is_wanted, near_bodies(reach, more, times.back() == 0));
  NearItems all = find(farther, more);
  all.add(needed);
  gathering.margin = margin_of(farther, reach, more);
  const MeetingRules rules{gathering.aside, kept_apart};
  gathering.gathered = std::make_unique<Gathered>(bodies, std::move(all), rules, options);
  gathering.needed_when_gathered = count;
}

std::optional<World::State::Margin> World::State::margin_of(const std::vector<BodyPair>& pairs, const Reach& reach,
                                                            double more) const {
  if (reach.part_of_way > 0) return std::nullopt;
  Margin margin{reach.separation, more, {}};
  for (const BodyPair& pair : pairs)
    for (const BodyId id : pair) {
      const Body& body = *bodies[at(id)];
      if (body.motion_kind() == MotionKind::turning) return std::nullopt;
      margin.ways.try_emplace(id, body);
    }
  return margin;
}

bool World::State::Margin::has(const BodyList& of_world, const std::vector<BodyPair>& pairs) const {
  std::map<BodyId, double> off;
  const auto off_of = [&](BodyId id) {
    const auto [place, is_new] = off.try_emplace(id, std::numeric_limits<double>::infinity());
    const auto way = ways.find(id);
    if (is_new && way != ways.end()) place->second = way->second.farthest_of(*of_world[at(id)]);
    return place->second;
  };
  return std::ranges::all_of(
      pairs, [&](const BodyPair& pair) { return (off_of(pair[0]) + off_of(pair[1])) * (1 + 0x1p-40) <= more; });
}

std::vector<double> World::State::times_of_pieces(const std::vector<BodyPair>& pairs) const {
  double pieces = 1;
  for (const BodyPair& pair : pairs) {
    const Body &a = *bodies[at(pair[0])], &b = *bodies[at(pair[1])];
    const double allowed = kDeviationInEdges * std::max(a.shape().edge, b.shape().edge);
    const double deviation = chord_deviation(a.acceleration() + b.acceleration(), Interval(1));  // of the whole step
    if (allowed > 0 && deviation > allowed) pieces = std::max(pieces, std::ceil(std::sqrt(deviation / allowed)));
  }
  pieces = std::min(pieces, kMostPieces);
  constexpr double kNoSimplePart = 0.02565;  // contacts happen at simple ones
  std::vector<double> times{0};
  for (int piece = 1; piece < pieces; ++piece) times.push_back((piece - kNoSimplePart) / pieces);
  times.push_back(1);
  return times;
}

void World::State::gather_moving(const Reach& reach) {
  const std::vector<BodyPair> near = near_bodies(reach, 0, false);
  gather(straight_, reach, is_straight, near, {0, 1});
  times_ = times_of_pieces(only(is_turning, near));
  gather(turning_, reach, is_turning, near, times_);
}

void World::State::gather_at_rest(double distance) {
  const Reach reach{distance};
  const auto any = [](const Body&, const Body&) { return true; };
  gather(at_rest_, reach, any, near_bodies(reach, 0, true), {0, 0});
}

}  // namespace tamis
