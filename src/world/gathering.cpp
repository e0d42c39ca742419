// What may touch in a question, found and gathered.
#include <algorithm>
#include <cmath>
#include <limits>

#include "curves/fine_point.hpp"
#include "numerics/error_bounds.hpp"
#include "paths/mesh_pieces.hpp"
#include "query/cancellation.hpp"
#include "topology/at.hpp"
#include "world/world_state.hpp"

namespace tamis {
namespace {

/// docs/history/performance.md, "What is gathered lasts". What does not serve so many questions is gathered the next
/// time with twice as much around it, while all that is gathered is no more than so many times what is needed.
constexpr int kServes = 16;
constexpr std::size_t kMostItems = 4;
constexpr double kLeastMoreInEdges = 0.5;
constexpr double kMostMoreInEdges = 64;  // where that is all there is, too
/// It is gathered anew once so few of the items that it was made for may touch; each so manieth search counts them.
constexpr std::size_t kShrunk = 4;
constexpr int kSearchesPerCount = 16;
constexpr double kEndsOfStep[] = {0, 1};

}  // namespace

double World::State::Reach::own(const Body& body) const {
  const double way =
      part_of_way > 0 && body.motion_kind() != MotionKind::still ? part_of_way * body.hull().extent() : 0;
  return body.radius() + way;
}

std::vector<BodyPair> World::State::near_bodies(const Reach& reach, double more, bool at_start) {
  stop_if_cancelled(options);
  const auto own = [&](const Body& body) { return reach.own(body) * kRoundedUp; };
  std::vector<BodyPair> pairs = near_bodies_.find(bodies, own, (reach.separation + more) * kRoundedUp, at_start);
  if (!kept_apart.empty()) std::erase_if(pairs, [&](const BodyPair& pair) { return kept_apart.contains(pair); });
  return pairs;
}

std::vector<BodyPair> World::State::only(const Gathering& gathering, std::vector<BodyPair> pairs) const {
  std::erase_if(pairs,
                [&](const BodyPair& pair) { return !gathering.wants(*bodies[at(pair[0])], *bodies[at(pair[1])]); });
  return pairs;
}

void World::State::gather(Gathering& gathering, const Reach& reach, const std::vector<BodyPair>& near,
                          std::span<const double> times) {
  const std::vector<BodyPair> wanted = only(gathering, near);
  if (wanted.empty()) return;
  if (gathering.serves(bodies, wanted, reach)) {
    gathering.is_asked = true;
    ++gathering.served;
    return;
  }
  Pieces pieces(times);
  const bool is_usable = gathering.gathered && gathering.gathered->keeps_motion_kinds(bodies);
  const bool counts = !is_usable || ++gathering.searched % kSearchesPerCount == 0;
  NearItems near_now;  // beside what is gathered, which is not looked at again, or all that is needed
  if (!counts) near_now.of_body = gathering.gathered->items().of_body;
  find_near(wanted, reach, 0, pieces, near_now);
  gathering.is_asked = !near_now.pairs.empty();
  if (!gathering.is_asked) return;
  const bool has_shrunk = counts && kShrunk * near_now.count() < gathering.needed_when_gathered;
  if (is_usable && !has_shrunk && gathering.gathered->items().includes(near_now)) {
    ++gathering.served;
    return;
  }
  if (counts) return gather_anew(gathering, reach, near_now, pieces);
  NearItems needed;
  find_near(wanted, reach, 0, pieces, needed);
  gather_anew(gathering, reach, needed, pieces);
}

void World::State::find_near(const std::vector<BodyPair>& pairs, const Reach& reach, double more, Pieces& pieces,
                             NearItems& items) const {
  const auto reach_of = [&](const Body& a, const Body& b) { return (reach.of(a, b) + more) * kRoundedUp; };
  add_near_items(
      bodies, pairs, reach_of, pieces, [this] { stop_if_cancelled(options); }, items);
}

void World::State::gather_anew(Gathering& gathering, const Reach& reach, const NearItems& needed, Pieces& pieces) {
  double edges = 0;
  for (const auto& [id, unused] : needed.of_body) edges += bodies[at(id)]->shape().edge;
  const double edge = edges / static_cast<double>(needed.of_body.size());
  double more_in_edges = gathering.more_in_edges;
  if (gathering.margin && gathering.served < kServes) more_in_edges = std::min(2 * more_in_edges, kMostMoreInEdges);
  NearItems items;
  std::optional<Margin> margin;
  while (true) {
    const double more = more_in_edges * edge;
    const std::vector<BodyPair> farther = only(gathering, near_bodies(reach, more, pieces.are_of_the_start()));
    items = needed;
    find_near(farther, reach, more, pieces, items);
    margin = margin_of(farther, reach, more);
    if (more_in_edges <= kLeastMoreInEdges || items.count() <= kMostItems * needed.count()) break;
    more_in_edges = std::max(more_in_edges / 2, kLeastMoreInEdges);
  }
  const MeetingRules rules{gathering.aside, kept_apart};
  gathering.gathered = std::make_unique<Gathered>(bodies, std::move(items), rules, options);
  // What is thrown before leaves all as it was.
  gathering.margin = std::move(margin);
  gathering.more_in_edges = more_in_edges;
  gathering.needed_when_gathered = needed.count();
  gathering.served = 0;
  gathering.searched = 0;
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
      pairs, [&](const BodyPair& pair) { return (off_of(pair[0]) + off_of(pair[1])) * kRoundedUp <= more; });
}

std::vector<double> World::State::times_of_pieces(const std::vector<BodyPair>& pairs) const {
  double pieces = 1;
  for (const BodyPair& pair : pairs) {
    const Body &a = *bodies[at(pair[0])], &b = *bodies[at(pair[1])];
    const double allowed = kChordDeviationInEdges * std::max(a.shape().edge, b.shape().edge);
    const double acceleration = a.acceleration() + b.acceleration();
    const double deviation = kPartBesideLine * chord_deviation(acceleration, Interval(1));  // of the whole step
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
  gather(straight_, reach, near, kEndsOfStep);
  times_ = times_of_pieces(only(turning_, near));
  gather(turning_, reach, near, times_);
}

}  // namespace tamis
