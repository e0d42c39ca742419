#include "worlds/edges.hpp"

#include <algorithm>

#include "search/query/pair_vertices.hpp"
#include "search/topology/at.hpp"

namespace tamis {

World::State::Edges::Edges(const State& world, const LinkageTree& tree, const PathOptions& asked)
    : tree_(tree), asked_(asked), world_(world), is_carried_(world.bodies.size()) {
  for (const BodyId body : tree.bodies) {
    is_carried_[at(body)] = true;
    world_.move(body, Rigid{});
  }
  for (const auto& body : world_.bodies)
    has_soft_ = has_soft_ || (body && body->deforming() && !is_carried_[at(body->id())]);
  prover_.emplace(world_.bodies, tree, world_.excluded_pairs, separation());
}

double World::State::Edges::separation() const { return asked_.min_separation.value_or(world_.options.min_separation); }

void World::State::Edges::move(std::span<const double> start, std::span<const double> end) {
  if (is_moved_) return;
  motions_.clear();
  tree_.add_motions(start, end, motions_);
  for (std::size_t i = 0; i < motions_.size(); ++i) world_.move(tree_.bodies[i], std::move(motions_[i]));
  is_moved_ = true;
}

bool World::State::Edges::prove(std::span<const double> start, std::span<const double> end, bool ends_at_collision) {
  is_moved_ = false;
  if (!tree_.turns_little(start, end)) move(start, end);  // refuses what turns too far
  const ProvenEdge& proven = prover_->run(start, end, ends_at_collision, world_.options);
  if (proven.collides) return false;
  enclosing_ = proven.at_start;
  pairs_ = proven.open;
  if (has_soft_) {
    move(start, end);
    world_.only_pairs = nullptr;
    const auto deforms = [&](BodyId body) { return world_.bodies[at(body)]->deforming() != nullptr; };
    for (const BodyPair& pair : world_.near_bodies({.separation = separation()}))
      if ((is_carried_[at(pair[0])] && deforms(pair[1])) || (is_carried_[at(pair[1])] && deforms(pair[0])))
        pairs_.push_back(pair);
    std::ranges::sort(pairs_);
  }
  return true;
}

std::optional<BodyPair> World::State::Edges::overlapping_pair(std::span<const double> start,
                                                              std::span<const double> end) {
  if (!pairs_.empty()) {
    move(start, end);
    world_.only_pairs = &pairs_;
    if (const auto pair = world_.overlapping_pair({})) return pair;
  }
  if (enclosing_.empty()) return std::nullopt;
  move(start, end);
  world_.only_pairs = &enclosing_;
  return world_.enclosing_pair({});
}

bool World::State::Edges::is_free(std::span<const double> start, std::span<const double> end, bool start_is_free) {
  if (!prove(start, end, true)) return false;
  if (!start_is_free && overlapping_pair(start, end)) return false;
  if (pairs_.empty()) return true;
  move(start, end);
  world_.only_pairs = &pairs_;
  return world_.is_free(asked_);
}

EdgeAnswer World::State::Edges::last_valid(std::span<const double> start, std::span<const double> end,
                                           bool start_is_free) {
  prove(start, end, false);
  EdgeAnswer answer;
  if (const auto pair = start_is_free ? std::nullopt : overlapping_pair(start, end)) {
    answer.fraction = answer.fraction_upper = 0;
    answer.overlaps_at_start = true;
    world_.only_pairs = &pairs_;
    answer.bodies = world_.intersecting_pair({}, Question::all_contacts).value_or(*pair);  // the first one
    return answer;
  }
  if (pairs_.empty()) return answer;
  move(start, end);
  world_.only_pairs = &pairs_;
  const EarliestBodyContact first = world_.earliest(asked_);
  answer.fraction = first.toi_lower;
  answer.fraction_upper = first.toi_upper;
  answer.contact = first.contact;
  if (first.contact) {
    answer.bodies = first.contact->bodies;
    answer.point = point_of(*first.contact);
  }
  return answer;
}

Point World::State::Edges::point_of(const BodyContact& contact) const {
  const std::array<double, 4> weights = weights_of(contact.kind, contact.u, contact.v);
  Point sum{0, 0, 0};
  for (std::size_t i = 0; i < second_feature(contact.kind); ++i) {
    const Point x = world_.bodies[at(contact.bodies[0])]->point_at(contact.vertices[i], contact.toi_lower).x;
    for (std::size_t k = 0; k < 3; ++k) sum[k] += weights[i] * x[k];
  }
  return sum;
}

}  // namespace tamis
