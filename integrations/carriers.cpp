#include "integrations/carriers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>
#include <unordered_set>

namespace tamis::adapters {
namespace {

/// Rounds over the contacts of one body with its carriers, which are few; the clamp holds back what these rounds leave.
constexpr int kRounds = 20;
/// In gaps a step: rounds that change no speed by more than this are the last ones.
constexpr double kSettled = 1e-6;
/// The part of a missing gap that one step restores. As in solvers a gap is restored over some steps, so that a body is
/// not pushed into what lies on it.
constexpr double kParted = 0.5;

}  // namespace

Carriers::Answer Carriers::answer(const Inertia& inertia, const Point& centre, Velocity& velocity, const Point& at,
                                  const Point& direction) {
  Answer answer{&velocity, direction, cross(minus(at, centre), direction)};
  for (std::size_t i = 0; i < 3; ++i) answer.linear[i] = direction[i] * inertia.inverse_mass[i];
  answer.angular = times(inertia.inverse_inertia, answer.about);
  return answer;
}

double Carriers::Answer::speed() const {
  return velocity ? dot(velocity->linear, direction) + dot(velocity->angular, about) : 0;
}

void Carriers::Answer::push(double impulse) const {
  velocity->linear = plus(velocity->linear, times(impulse, linear));
  velocity->angular = plus(velocity->angular, times(impulse, angular));
}

double Carriers::Contact::push() {
  if (!(give > 0)) return 0;  // a body on an axle
  const double before = impulse;
  const double speed = body.speed() - other.speed();
  impulse = std::max(0.0, before - (speed + allowed + softness * before) / (give + softness));
  body.push(impulse - before);
  if (other_gives) other.push(before - impulse);
  return std::abs(impulse - before) * give;
}

void Carriers::rub(Body& body, Body& other, Contact& contact) {
  if (!(contact.friction * contact.impulse > contact.rubbed)) return;
  const std::size_t side = contact.side;
  const std::array points{contact.near->points[side], contact.near->points[1 - side]};
  const auto speed_at = [](const Body& one, const Point& at) {
    return plus(one.velocity.linear, cross(one.velocity.angular, minus(at, one.centre)));
  };
  const Point speed = minus(speed_at(body, points[0]), speed_at(other, points[1])), normal = contact.body.direction;
  const Point sliding = minus(speed, times(dot(speed, normal), normal));
  const double fast = length(sliding), most = contact.friction * contact.impulse - contact.rubbed;
  if (!(fast > 0)) return;
  const Point along = times(1 / fast, sliding);
  const Answer first = answer(body.inertia, body.centre, body.velocity, points[0], along);
  const Answer second = answer(other.inertia, other.centre, other.velocity, points[1], along);
  const double give = first.give() + (contact.other_gives ? second.give() : 0);
  if (!(give > 0)) return;
  const double impulse = std::min(most, fast / give);
  contact.rubbed += impulse;
  first.push(-impulse);
  if (contact.other_gives) second.push(impulse);
}

Carriers::Carriers(const Near& near, const WantedStep& step, double gap) : gap_(gap), seconds_(step.seconds()) {
  const std::span<const BodyId> moving = step.moving();
  const std::unordered_set<BodyId> may_move(moving.begin(), moving.end());
  std::unordered_map<BodyId, std::size_t> known;
  const auto place_of = [&](BodyId id) {
    const auto [place, is_new] = known.try_emplace(id, bodies_.size());
    if (is_new) {
      Body& body = bodies_.emplace_back(Body{id, may_move.contains(id)});
      body.centre = step.pose(id, 0).position;
      body.velocity = step.velocity(id);
      if (body.moves) body.inertia = step.inertia(id);
    }
    return place->second;
  };
  for (const auto& [pair, found] : near) {
    const std::array at{place_of(pair[0]), place_of(pair[1])};
    const double friction = step.friction(pair);
    for (const NearContact& contact : found.contacts)
      for (const std::size_t i : {0U, 1U})
        bodies_[at[i]].contacts.push_back({.near = &contact, .side = i, .other_at = at[1 - i], .friction = friction});
  }
  find_levels();
  for (const std::size_t i : order_) keep_carriers(bodies_[i]);
}

void Carriers::keep_carriers(Body& body) {
  std::erase_if(body.contacts, [&](const Contact& contact) { return bodies_[contact.other_at].level >= body.level; });
  for (Contact& contact : body.contacts) {
    const NearContact& near = *contact.near;
    Body& other = bodies_[contact.other_at];
    const Point up = contact.side == 0 ? near.normal : times(-1, near.normal);
    contact.body = answer(body.inertia, body.centre, body.velocity, near.points[contact.side], up);
    contact.other = answer(other.inertia, other.centre, other.velocity, near.points[1 - contact.side], up);
    contact.above_gap = near.distance() - gap_;
    contact.give = contact.body.give() + (contact.other_gives ? contact.other.give() : 0);
  }
}

/// Breadth first, from the objects that stand; then, in each group without one, from its heaviest body.
void Carriers::find_levels() {
  std::vector<std::size_t> roots(bodies_.size());
  for (std::size_t i = 0; i < roots.size(); ++i) roots[i] = i;
  const auto give = [&](std::size_t i) {
    return bodies_[i].moves ? *std::ranges::max_element(bodies_[i].inertia.inverse_mass) : -1.0;
  };
  std::ranges::stable_sort(roots, {}, give);
  for (auto root = roots.begin(); root != roots.end(); ++root) {
    if (bodies_[*root].level >= 0) continue;
    const bool nothing_stands = bodies_[*root].moves;
    std::vector<std::size_t> reached;
    const auto reach = [&](std::size_t i, int level) {
      if (bodies_[i].level >= 0) return;
      bodies_[i].level = level;
      reached.push_back(i);
    };
    reach(*root, 0);
    // All standing objects, the first of `roots`, are reached at once: a body's level counts from the nearest of them.
    for (auto next = root + 1; next != roots.end() && !bodies_[*next].moves; ++next) reach(*next, 0);
    for (std::size_t next = 0; next < reached.size(); ++next) {
      const std::size_t i = reached[next];
      if (bodies_[i].level > 0) order_.push_back(i);
      for (Contact& contact : bodies_[i].contacts) {
        contact.other_gives = nothing_stands;
        reach(contact.other_at, bodies_[i].level + 1);
      }
    }
  }
}

template <class Allowed>
void Carriers::push(Velocities& velocities, const Allowed& allowed, bool is_soft) {
  for (Body& body : bodies_)
    if (body.moves) body.velocity = velocities.at(body.id);
  for (const std::size_t i : order_) {
    std::vector<Contact>& contacts = bodies_[i].contacts;
    for (Contact& contact : contacts) {
      contact.impulse = contact.rubbed = 0;
      // Shared by the contacts with one body: two carriers push alike however many contacts each has.
      const auto count = std::ranges::count(contacts, contact.other_at, &Contact::other_at);
      contact.softness = is_soft && contact.above_gap < 0 ? contact.give * static_cast<double>(count) / 8 : 0;
      contact.allowed = allowed(contact.above_gap) / seconds_;
    }
    const double settled = kSettled * gap_ / seconds_;
    double change = 2 * settled;
    for (int round = 0; round < kRounds && change > settled; ++round) {
      change = 0;
      for (Contact& contact : contacts) {
        change = std::max(change, contact.push());
        if (!is_soft) rub(bodies_[i], bodies_[contact.other_at], contact);
      }
    }
  }
  for (const Body& body : bodies_)
    if (body.moves) velocities.at(body.id) = body.velocity;
}

void Carriers::take_speed(Velocities& velocities) {
  push(
      velocities, [](double above_gap) { return std::max(0.0, above_gap); }, false);
}

void Carriers::part(Velocities& ways) {
  push(
      ways, [](double above_gap) { return above_gap < 0 ? above_gap * kParted : above_gap; }, true);
}

void Carriers::stop(const NearContact& contact, const WantedStep& step, Velocities& velocities) {
  std::array<Answer, 2> answers;
  double give = 0;
  for (const std::size_t i : {0U, 1U}) {
    const BodyId id = contact.bodies[i];
    const auto known = velocities.find(id);
    if (known == velocities.end()) continue;
    answers[i] = answer(step.inertia(id), step.pose(id, 0).position, known->second, contact.points[i], contact.normal);
    give += answers[i].give();
  }
  const double speed = answers[0].speed() - answers[1].speed();
  if (!(give > 0) || speed >= 0) return;
  if (answers[0].velocity) answers[0].push(-speed / give);
  if (answers[1].velocity) answers[1].push(speed / give);
}

}  // namespace tamis::adapters
