#include "integrations/clamp.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "integrations/followers.hpp"
#include "integrations/speeds.hpp"
#include "tamis/error.hpp"

namespace tamis::adapters {
namespace {

/// In gaps: if two bodies would touch after going less than this together, they stay. So their distance remains far
/// above 1e-15, by which the end of one step's path may differ from the start of the next.
constexpr double kLeastTravel = 1e-3;

/// All go all their way.
Fractions whole_ways(const WantedStep& step) {
  Fractions fractions;
  for (const BodyId body : step.moving()) fractions[body] = 1;
  return fractions;
}

class Clamp {
 public:
  Clamp(World& world, WantedStep& step, const Beginning& beginning, const ClampOptions& options)
      : world_(world),
        step_(step),
        beginning_(beginning),
        options_(options),
        velocities_(take_speeds(step, beginning.near, options.gap)),
        fractions_(whole_ways(step)),
        followers_(beginning.near, step, options.gap, fractions_) {}

  ClampedStep run() {
    followers_.hold_back();
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
    stop_where_met(hits_, beginning_.near, step_, velocities_);
    for (const BodyId body : step_.moving())
      result.ends.push_back(end_of(body, step_, fractions_.at(body), velocities_.at(body), options_.gap));
    return result;
  }

 private:
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
    std::set<BodyId> slower = followers_.hold_back();
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

  World& world_;
  WantedStep& step_;
  const Beginning& beginning_;
  const ClampOptions& options_;
  Velocities velocities_;  ///< with which the next step begins
  Fractions fractions_;
  Followers followers_;
  std::map<BodyId, double> travels_;  ///< for each body of moving(), a bound of how far any of its points goes
  std::vector<NearContact> hits_;     ///< where bodies met that the engine's solver could see
};

}  // namespace

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
