#include "worlds/gathering.hpp"

#include <algorithm>
#include <cmath>

#include "curves/motions/curvature.hpp"
#include "curves/paths/mesh_pieces.hpp"
#include "pair/motion/time_clip.hpp"
#include "search/query/cancellation.hpp"
#include "search/topology/at.hpp"
#include "worlds/world_state.hpp"

namespace tamis {
namespace {

/// A mesh is gathered anew once fewer than 1 / kShrunk of the items needed when it was made may still touch. Every
/// kSearchesPerCount-th search counts them.
constexpr std::size_t kShrunk = 4;
constexpr int kSearchesPerCount = 16;

}  // namespace

std::vector<BodyPair> World::State::wanted_pairs(const Gathering& gathering, std::vector<BodyPair> pairs) const {
  std::erase_if(pairs,
                [&](const BodyPair& pair) { return !gathering.wants(*bodies[at(pair[0])], *bodies[at(pair[1])]); });
  return pairs;
}

bool World::State::gather(Gathering& gathering, const BodyList& seen, const NearDistance& distance,
                          const std::vector<BodyPair>& pairs, std::span<const double> times) {
  if (pairs.empty()) return false;
  const bool is_usable = gathering.gathered && gathering.gathered->keeps_motion_kinds(seen);
  const bool counts = !is_usable || gathering.serves_once() || ++gathering.searched % kSearchesPerCount == 0;
  // All needed items if `counts`; else the gathered items, which are not tested again, and new ones.
  NearItems near_now;
  if (!counts) near_now.of_body = gathering.gathered->items().of_body;
  add_near_items(seen, pairs, distance, times, options, near_now);
  if (near_now.pairs.empty()) return false;
  const bool has_shrunk = counts && kShrunk * near_now.count() < gathering.needed_when_gathered;
  if (is_usable && !has_shrunk && gathering.gathered->items().includes(near_now)) {
    ++gathering.served;
    return true;
  }
  if (!counts) {
    near_now = {};
    add_near_items(seen, pairs, distance, times, options, near_now);
  }
  gather_anew(gathering, seen, pairs, distance, near_now, times);
  return true;
}

void World::State::gather_anew(Gathering& gathering, const BodyList& seen, const std::vector<BodyPair>& near,
                               NearDistance distance, const NearItems& needed, std::span<const double> times) {
  double edge = 0;  // of the finest body: parts of a coarse edge would gather all of a fine body
  for (const auto& [id, unused] : needed.of_body)
    if (const double own = seen[at(id)]->shape().edge; edge == 0 || (0 < own && own < edge)) edge = own;
  const int in_vain = gathering.gathered && gathering.served == 0 ? gathering.in_vain + 1 : 0;
  NearItems items = needed;
  if (!gathering.serves_once()) {
    distance.margin = gathering.margin_in_edges * edge;
    const bool is_of_world = &seen == &bodies;
    add_near_items(seen, is_of_world ? wanted_pairs(gathering, near_bodies(distance)) : near, distance, times, options,
                   items);
  }
  stop_if_cancelled(options);
  gathering.gathered = std::make_unique<Gathered>(seen, std::move(items), gathering.least, excluded_pairs, options);
  stop_if_cancelled(options);
  // Nothing throws from here on; an exception before leaves the gathering as it was.
  gathering.needed_when_gathered = needed.count();
  gathering.served = 0;
  gathering.in_vain = in_vain;
  gathering.searched = 0;
}

std::vector<double> World::State::times_of_pieces(const BodyList& seen, const std::vector<BodyPair>& pairs,
                                                  const NearDistance& distance) {
  double pieces = 1;
  const Interval whole_step = chord_factor(Interval(1));
  for (const BodyPair& pair : pairs) {
    const Body &a = *seen[at(pair[0])], &b = *seen[at(pair[1])];
    const double allowed = kChordDeviationInEdges * std::max({a.shape().edge, b.shape().edge, distance.between(a, b)});
    const double acceleration = a.curvature().acceleration + b.curvature().acceleration;
    const double deviation = kShiftedChordPart * Curvature{acceleration}.deviation(whole_step);
    if (allowed > 0 && deviation > allowed) pieces = std::max(pieces, std::ceil(std::sqrt(deviation / allowed)));
  }
  pieces = std::min(pieces, kMostPieces);
  constexpr double kNoSimplePart = 0.02565;  // contacts happen at simple fractions
  std::vector<double> times{0};
  // How far a pair must be searched grows with its displacement since t=0 (PathSearch::radii_to_search).
  constexpr double kFirstPiece = 0x1p-6;
  const double first = pieces > 1 ? (1 - kNoSimplePart) / pieces : 1;
  if (distance.displacement_factor > 0) {
    constexpr double kGrowth = kNearMiddle * kNearMiddle;
    for (double time = first * kGrowth; time > kFirstPiece; time *= kGrowth) times.push_back(time);
    std::ranges::sort(times);
  }
  for (int piece = 1; piece < pieces; ++piece) times.push_back((piece - kNoSimplePart) / pieces);
  times.push_back(1);
  return times;
}

}  // namespace tamis
