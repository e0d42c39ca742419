#include "integrations/clamp.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "integrations/carriers.hpp"
#include "tamis/error.hpp"

namespace tamis::adapters {
namespace {

/// In gaps: if two bodies would touch after going less than this together, they stay. So their distance remains far
/// above 1e-15, by which the end of one step's path may differ from the start of the next.
constexpr double kLeastTravel = 1e-3;
/// In gaps: a pair that is known to be this near stays, too, if it touches before it has gone a gap. Otherwise its
/// distance would be halved in each step, until rounding to the engine's floats moves a body by more: by 2^-24 of its
/// distance from the origin, which at 800 units is this part of a gap of 1e-3. Farther from the origin bodies stay more
/// often; none passes through another.
constexpr double kLeastDistance = 0.05;
/// In radians: a body that turns by more than this comes to another place than its velocity says, and stands for
/// nothing if it is held back there.
constexpr double kSmallTurn = 0.3;
/// Rounds over the places where bodies met: each may bring bodies nearer at another one.
constexpr int kStopRounds = 10;
/// A body that goes less than this part of its way keeps so much of its speed: if it kept all, gravity would add to it
/// in each step, and where nothing else stops it it would hang there for ever. A slow body, which goes less than kSlow
/// gaps in a step, must go less: it may be about to tip over.
constexpr double kStands = 0.01, kStandsSlow = 1e-3, kKeptSpeed = 0.5, kSlow = 10;
/// In gaps: bodies that were apart, and are farther apart than this by all pairs of features, are apart: the start of a
/// step differs from the end of the last one by some 1e-15.
constexpr double kToldApart = 1e-6;
/// In steps: the precision that suffices for the time of a contact, and for the part of its way that a body may go.
constexpr double kTolerance = 1e-4;
/// Sweeps over all approaches; more sweeps would only save questions.
constexpr int kMostSweeps = 32;

bool collide_at(const Bodies& engine, const std::array<BodyId, 2>& bodies, const std::array<Index, 2>& vertices) {
  return engine.collides(pair_of(bodies)) && engine.collides_at(bodies, vertices);
}

/// A place at which two bodies are near each other when a step begins.
struct Approach {
  BodyPair bodies;
  double distance;                ///< > 0
  std::array<double, 2> closing;  ///< by how much each body's whole way reduces the distance; 0 for a body that stays
};

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

/// Where bodies are near each other. With these a body that follows one that is held back is held back with it; without
/// them a pile would take a question for each of its bodies. No proof rests on them.
std::vector<Approach> approaches(const Near& near, const WantedStep& step) {
  std::map<BodyId, WholeWay> ways;
  for (const BodyId body : step.moving()) ways.emplace(body, WholeWay(step, body));
  const auto turns = [&](BodyId body) {
    const auto way = ways.find(body);
    return way != ways.end() && !way->second.is_nearly_straight();
  };
  std::vector<Approach> all;
  for (const auto& [bodies, found] : near)
    for (const NearContact& contact : found.contacts) {
      if (!(contact.distance() > 0) || turns(bodies[0]) || turns(bodies[1])) continue;
      Approach& approach = all.emplace_back(Approach{bodies, contact.distance(), {0, 0}});
      for (const std::size_t k : {0U, 1U})
        if (const auto way = ways.find(bodies[k]); way != ways.end()) {
          const double parting = dot(way->second.of(contact.points[k]), contact.normal);
          approach.closing[k] = k == 0 ? -parting : parting;
        }
    }
  return all;
}

/// Takes speeds (the first part of the policy). Returns the velocities with which the next step begins.
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

class Clamp {
 public:
  Clamp(World& world, WantedStep& step, const Beginning& beginning, const ClampOptions& options)
      : world_(world),
        step_(step),
        beginning_(beginning),
        options_(options),
        velocities_(take_speeds(step, beginning.near, options.gap)) {
    for (const BodyId body : step.moving()) fractions_[body] = 1;
    const auto fraction = [&](BodyId body) {
      const auto known = fractions_.find(body);
      return known == fractions_.end() ? nullptr : &known->second;
    };
    for (const Approach& approach : approaches(beginning.near, step))
      approaches_.push_back({approach, {fraction(approach.bodies[0]), fraction(approach.bodies[1])}});
  }

  ClampedStep run() {
    hold_back_followers();
    for (const BodyId body : step_.moving()) set_off(body);
    ClampedStep result;
    for (bool is_free = false; !is_free;) {
      ++result.questions;
      const FirstContacts contacts = first_contacts();
      for (const auto& [bodies, contact] : contacts) {
        result.limits.push_back(contact);
        if (beginning_.near.contains(bodies)) hits_.push_back(contact_at(world_, step_, contact, contact.toi_lower));
      }
      hold_back(contacts, result.questions <= options_.rounds);
      is_free = contacts.empty();
    }
    stop_hits();
    for (const BodyId body : step_.moving()) result.ends.push_back(end_of(body));
    return result;
  }

 private:
  struct KnownApproach : Approach {
    std::array<double*, 2> fractions;  ///< in `fractions_`; null for a body that stays
  };

  /// Shortens ways so that bodies keep apart at the approaches, to first order. It sweeps forwards and backwards
  /// through the approaches, as followers have followers. Returns the bodies whose fractions change.
  std::set<BodyId> hold_back_followers() {
    std::set<BodyId> slower;
    bool changes = true;
    for (int sweep = 0; changes && sweep < kMostSweeps; ++sweep) {
      changes = false;
      for (const KnownApproach& approach : approaches_) changes |= hold_back_at(approach, slower);
      std::ranges::reverse(approaches_);
    }
    return slower;
  }

  bool hold_back_at(const KnownApproach& approach, std::set<BodyId>& slower) {
    double closing = 0, parting = 0;
    for (const std::size_t i : {0U, 1U}) {
      if (!approach.fractions[i]) continue;
      const double way = *approach.fractions[i] * approach.closing[i];
      (way > 0 ? closing : parting) += way;
    }
    const double kept = std::clamp(approach.distance / 2, kLeastDistance * options_.gap, options_.gap);
    const double allowed = std::max(0.0, approach.distance - kept) - parting;
    if (closing <= allowed * (1 + kTolerance)) return false;
    for (const std::size_t i : {0U, 1U}) {
      if (!approach.fractions[i] || approach.closing[i] <= 0) continue;
      *approach.fractions[i] *= allowed / closing;
      slower.insert(approach.bodies[i]);
    }
    return true;
  }

  void set_off(BodyId body) {
    const Pose start = step_.pose(body, 0), end = step_.pose(body, fractions_.at(body));
    const RigidChain way = chain_between(start, end);
    double& travel = travels_[body];
    travel = 0;
    for (const RigidLink& link : way)
      travel += length({link.end.position[0] - link.start.position[0], link.end.position[1] - link.start.position[1],
                        link.end.position[2] - link.start.position[2]}) +
                step_.radius(body) * length({link.end.rotation[0] - link.start.rotation[0],
                                             link.end.rotation[1] - link.start.rotation[1],
                                             link.end.rotation[2] - link.start.rotation[2]});
    if (start.position == end.position && start.rotation == end.rotation)
      world_.move(body, Static{start});
    else
      world_.move(body, Rigid{way});
  }

  using FirstContacts = std::map<BodyPair, BodyContact>;

  bool may_collide(const BodyPair& bodies) const {
    return !beginning_.overlapping.contains(bodies) && step_.collides(bodies);
  }
  bool collides_at(const BodyContact& contact) const {
    const Index second = contact.vertices[contact.kind == PairKind::edge_edge ? 2 : 1];
    return step_.collides_at(contact.bodies, {contact.vertices[0], second});
  }

  /// All contacts of a pair are needed only where its first one is of parts that do not collide: it hides others.
  FirstContacts first_contacts() {
    const PathOptions asked{.at_start = AtStart::ignore, .tolerance = kTolerance};
    std::vector<BodyContact> contacts = world_.first_contacts(asked);
    std::erase_if(contacts, [&](const BodyContact& contact) { return !may_collide(pair_of(contact.bodies)); });
    const auto counts = [&](const BodyContact& contact) { return collides_at(contact); };
    if (!std::ranges::all_of(contacts, counts)) contacts = world_.contacts(asked);
    FirstContacts first;
    for (const BodyContact& contact : contacts) {
      const BodyPair bodies = pair_of(contact.bodies);
      if (!may_collide(bodies) || !collides_at(contact)) continue;
      const auto [known, is_new] = first.try_emplace(bodies, contact);
      if (!is_new && contact.toi_lower < known->second.toi_lower) known->second = contact;
    }
    return first;
  }

  bool may_move(BodyId body) const {
    const auto known = fractions_.find(body);
    return known != fractions_.end() && known->second > 0;
  }

  void refuse_unless_one_may_move(const BodyPair& bodies) const {
    if (std::ranges::any_of(bodies, [&](BodyId body) { return may_move(body); })) return;
    throw InvalidStep(
        "bodies " + std::to_string(bodies[0]) + " and " + std::to_string(bodies[1]) +
        " touch, and neither can be held back any more: name those that move, and no others, in moving()");
  }

  void hold_back(const FirstContacts& contacts, bool by_part) {
    std::map<BodyId, double> parts;
    for (const auto& [bodies, contact] : contacts) {
      refuse_unless_one_may_move(bodies);
      for (const BodyId body : bodies)
        if (may_move(body)) {
          double& part = parts.try_emplace(body, 1).first->second;
          part = std::min(part, by_part ? part_before(bodies, contact.toi_lower) : 0);
        }
    }
    for (const auto& [body, part] : parts) fractions_.at(body) *= part;
    std::set<BodyId> slower = hold_back_followers();
    for (const auto& [body, part] : parts) slower.insert(body);
    for (const BodyId body : slower) set_off(body);
  }

  bool starts_too_near(const BodyPair& bodies) const {
    const auto known = beginning_.near.find(bodies);
    return known != beginning_.near.end() && known->second.distance < kLeastDistance * options_.gap;
  }

  /// The part of its way that each of two bodies may go if they touch at `time`.
  double part_before(const BodyPair& bodies, double time) const {
    double travel = 0;
    for (const BodyId body : bodies)
      if (const auto known = travels_.find(body); known != travels_.end()) travel += known->second;
    const double way = travel * time;
    if (way < kLeastTravel * options_.gap || (way < options_.gap && starts_too_near(bodies))) return 0;
    return std::max(time - options_.gap / travel, time / 2);
  }

  /// Bodies that met may meet at another of their near places next.
  void stop_hits() {
    std::set<BodyPair> met;
    for (const NearContact& hit : hits_) met.insert(hit.bodies);
    for (const BodyPair& bodies : met) {
      const std::vector<NearContact>& near = beginning_.near.at(bodies).contacts;
      hits_.insert(hits_.end(), near.begin(), near.end());
    }
    for (int round = 0; round < kStopRounds; ++round)
      for (const NearContact& hit : hits_) Carriers::stop(hit, step_, velocities_);
  }

  BodyEnd end_of(BodyId body) const {
    BodyEnd end{fractions_.at(body), velocities_.at(body)};
    const auto& [linear, angular] = end.velocity;
    const double way = step_.seconds() * (length(linear) + step_.radius(body) * length(angular));
    if (end.fraction < (way < kSlow * options_.gap ? kStandsSlow : kStands))
      end.velocity = {times(kKeptSpeed, linear), times(kKeptSpeed, angular)};
    return end;
  }

  World& world_;
  WantedStep& step_;
  const Beginning& beginning_;
  const ClampOptions& options_;
  Velocities velocities_;  ///< with which the next step begins
  std::map<BodyId, double> fractions_;
  std::vector<KnownApproach> approaches_;
  std::map<BodyId, double> travels_;  ///< for each body of moving(), a bound of how far any of its points goes
  std::vector<NearContact> hits_;     ///< where bodies met that the engine's solver could see
};

}  // namespace

BodyMotion resting(const Pose& pose) { return Rigid{RigidChain{{pose, pose}}}; }

std::set<BodyPair> overlapping(World& world) {
  std::set<BodyPair> pairs;
  for (const BodyIntersection& intersection : world.intersections()) pairs.insert(pair_of(intersection.bodies));
  return pairs;
}

std::set<BodyPair> overlapping(World& world, const Bodies& bodies) {
  std::set<BodyPair> pairs;
  for (const BodyIntersection& place : world.intersections())
    if (collide_at(bodies, place.bodies, {place.edge[0], place.face[0]})) pairs.insert(pair_of(place.bodies));
  return pairs;
}

Beginning beginning(World& world, const Bodies& bodies, const ClampOptions& options, bool are_apart) {
  validate(options);
  Beginning now{{}, near_bodies(world, bodies, 2 * options.gap)};
  const auto is_told = [&](const auto& pair) { return pair.second.distance > kToldApart * options.gap; };
  if (are_apart && std::ranges::all_of(now.near, is_told)) return now;
  now.overlapping = overlapping(world, bodies);
  for (const BodyPair& bodies_of_one : now.overlapping) now.near.erase(bodies_of_one);
  return now;
}

void validate(const ClampOptions& options) {
  if (!(options.gap > 0) || std::isinf(options.gap))
    throw InvalidOptions("the gap is " + std::to_string(options.gap) + ": give one that is finite and above 0");
  if (options.rounds < 0) throw InvalidOptions("rounds is " + std::to_string(options.rounds) + ": give a number >= 0");
}

ClampedStep clamp(World& world, WantedStep& step, const Beginning& beginning, const ClampOptions& options) {
  validate(options);
  if (!(step.seconds() > 0) || std::isinf(step.seconds()))
    throw InvalidOptions("a step takes " + std::to_string(step.seconds()) + " seconds: give a finite time above 0");
  std::vector<std::pair<BodyId, BodyMotion>> before;
  for (const BodyId body : step.moving()) before.emplace_back(body, world.motion(body));
  try {
    return Clamp(world, step, beginning, options).run();
  } catch (...) {
    for (auto& [body, motion] : before) world.move(body, std::move(motion));
    throw;
  }
}

}  // namespace tamis::adapters
