#include "adapters/clamp.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

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
/// In steps: the precision that suffices for the time of a contact, and for the part of its way that a body may go.
constexpr double kTolerance = 1e-4;
/// Sweeps over all approaches; more sweeps would only save questions.
constexpr int kMostSweeps = 32;

bool collide_at(const WantedStep& step, const std::array<BodyId, 2>& bodies, const std::array<Index, 2>& vertices) {
  return step.collides(pair_of(bodies)) && step.collides_at(bodies, vertices);
}

double length(const Point& v) { return std::hypot(v[0], v[1], v[2]); }

class Clamp {
 public:
  Clamp(World& world, const WantedStep& step, const std::set<BodyPair>& overlapping, const ClampOptions& options)
      : world_(world), step_(step), overlapping_(overlapping), options_(options) {
    for (const BodyId body : step.moving()) fractions_[body] = 1;
    const auto fraction = [&](BodyId body) {
      const auto known = fractions_.find(body);
      return known == fractions_.end() ? nullptr : &known->second;
    };
    for (const Approach& approach : step.approaches())
      approaches_.push_back({approach, {fraction(approach.bodies[0]), fraction(approach.bodies[1])}});
  }

  ClampedStep run() {
    hold_back_followers();
    for (const BodyId body : step_.moving()) set_off(body);
    ClampedStep result;
    for (bool is_free = false; !is_free;) {
      ++result.questions;
      const FirstContacts contacts = first_contacts();
      for (const auto& [bodies, contact] : contacts) result.limits.push_back(contact);
      hold_back(contacts, result.questions <= options_.rounds);
      is_free = contacts.empty();
    }
    for (const BodyId body : step_.moving()) result.fractions.push_back(fractions_.at(body));
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
    const Chain way = between(start, end);
    double& travel = travels_[body];
    travel = 0;
    for (const Link& link : way)
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

  bool may_collide(const BodyPair& bodies) const { return !overlapping_.contains(bodies) && step_.collides(bodies); }
  bool collides_at(const BodyContact& contact) const {
    const Index second = contact.vertices[contact.kind == PairKind::edge_edge ? 2 : 1];
    return step_.collides_at(contact.bodies, {contact.vertices[0], second});
  }

  /// All contacts of a pair are needed only where its first one is of parts that do not collide: it hides others.
  FirstContacts first_contacts() {
    const QueryOptions asked{.at_start = AtStart::ignore, .tolerance = kTolerance};
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
    return std::ranges::any_of(approaches_, [&](const Approach& approach) {
      return approach.bodies == bodies && approach.distance < kLeastDistance * options_.gap;
    });
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

  World& world_;
  const WantedStep& step_;
  const std::set<BodyPair>& overlapping_;
  const ClampOptions& options_;
  std::map<BodyId, double> fractions_;
  std::vector<KnownApproach> approaches_;
  std::map<BodyId, double> travels_;  ///< for each body of moving(), a bound of how far any of its points goes
};

}  // namespace

BodyPair pair_of(const std::array<BodyId, 2>& bodies) {
  return {std::min(bodies[0], bodies[1]), std::max(bodies[0], bodies[1])};
}

BodyMotion resting(const Pose& pose) { return Rigid{Chain{{pose, pose}}}; }

std::set<BodyPair> overlapping(World& world) {
  std::set<BodyPair> pairs;
  for (const BodyIntersection& intersection : world.intersections()) pairs.insert(pair_of(intersection.bodies));
  return pairs;
}

std::set<BodyPair> overlapping(World& world, const WantedStep& step) {
  std::set<BodyPair> pairs;
  for (const BodyIntersection& place : world.intersections())
    if (collide_at(step, place.bodies, {place.edge[0], place.face[0]})) pairs.insert(pair_of(place.bodies));
  return pairs;
}

void validate(const ClampOptions& options) {
  if (!(options.gap > 0) || std::isinf(options.gap))
    throw InvalidOptions("the gap is " + std::to_string(options.gap) + ": give one that is finite and above 0");
  if (options.rounds < 0) throw InvalidOptions("rounds is " + std::to_string(options.rounds) + ": give a number >= 0");
}

ClampedStep clamp(World& world, const WantedStep& step, const std::set<BodyPair>& overlapping,
                  const ClampOptions& options) {
  validate(options);
  std::vector<std::pair<BodyId, BodyMotion>> before;
  for (const BodyId body : step.moving()) before.emplace_back(body, world.motion(body));
  try {
    return Clamp(world, step, overlapping, options).run();
  } catch (...) {
    for (auto& [body, motion] : before) world.move(body, std::move(motion));
    throw;
  }
}

}  // namespace tamis::adapters
