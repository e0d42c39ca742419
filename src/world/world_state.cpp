#include "world/world_state.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "detect/make_detector.hpp"
#include "detect/pair_faults.hpp"
#include "detect/validate.hpp"
#include "numerics/number_text.hpp"
#include "paths/path_search.hpp"
#include "query/cancellation.hpp"
#include "query/contact_collector.hpp"
#include "query/stage_counts.hpp"
#include "tamis/error.hpp"
#include "topology/at.hpp"

namespace tamis {
namespace {

/// What is gathered is more than what may touch now, by so many mean edges: it serves the steps that follow.
constexpr double kMoreInEdges = 0.5;
/// It is gathered anew once so few of the items that it was made for may touch.
constexpr std::size_t kShrunk = 4;
constexpr double kMostPieces = 4096;

Options valid(Options options) {
  const PairFilter& filter = options.filter;
  if (!filter.group_of_vertex.empty() || !filter.groups_may_touch.empty() || filter.group_count != 1 || filter.accepts)
    throw InvalidOptions(
        "the options of a world have groups or a function that accepts pairs, which speak of one "
        "mesh: say which bodies may touch by set_may_touch");
  if (!options.radii.empty())
    throw InvalidOptions("the options of a world have radii, which are one a group of one mesh: give min_separation");
  validate(options, Mesh(1, {}, {}, {0}));
  return options;
}

/// By kind, then body and own vertex of all four.
template <class Pair>
bool is_before(const Pair& a, const Pair& b) {
  if (a.kind != b.kind) return a.kind < b.kind;
  const std::size_t second = second_feature(a.kind);
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t body = i < second ? 0 : 1;
    if (a.bodies[body] != b.bodies[body]) return a.bodies[body] < b.bodies[body];
    if (a.vertices[i] != b.vertices[i]) return a.vertices[i] < b.vertices[i];
  }
  return false;
}

/// Takes what comes sooner.
void take_sooner(EarliestBodyContact& first, const EarliestContact& other,
                 const std::function<BodyContact()>& contact) {
  first.toi_upper = std::min(first.toi_upper, other.toi_upper);
  if (!other.contact || other.toi_lower > first.toi_lower) return;
  BodyContact named = contact();
  if (first.contact && other.toi_lower == first.toi_lower && !is_before(named, *first.contact)) return;
  first.toi_lower = other.toi_lower;
  first.contact = named;
}

std::array<BodyId, 2> twice(BodyId body) { return {body, body}; }

BodyContact named(const Contact& contact, const Gathered& gathered) {
  BodyContact result{contact, {}};
  result.bodies = gathered.name(contact.kind, result.vertices);
  return result;
}

/// As bodies are asked that go straight; curves alone have a tolerance. Whoever fails for what touches at the start
/// asks for it, and names the bodies.
QueryOptions of_curves(QueryOptions asked) {
  if (asked.at_start == AtStart::fail) asked.at_start = AtStart::report;
  return asked;
}
QueryOptions of_steps(const QueryOptions& asked) {
  QueryOptions options = of_curves(asked);
  options.tolerance.reset();
  return options;
}

bool is_straight(const Body& a, const Body& b) { return a.way() != Way::turning && b.way() != Way::turning; }
bool is_turning(const Body& a, const Body& b) { return !is_straight(a, b); }

}  // namespace

World::State::State(Options o) : options(valid(std::move(o))) {}

Body& World::State::body(BodyId id) {
  if (id < 0 || at(id) >= bodies.size())
    throw InvalidOptions("the world has no body " + std::to_string(id) + ": give a number that `add` has returned");
  if (!bodies[at(id)])
    throw InvalidOptions("body " + std::to_string(id) + " has been removed: name one that is still there");
  return *bodies[at(id)];
}

void World::State::forget(const Body& changed) {
  must_gather_ = true;
  forget_if_still(changed);
}

double World::State::Reach::of(const Body& a, const Body& b) const {
  const auto way = [](const Body& body) { return body.way() == Way::still ? 0 : body.hull().extent(); };
  const double both = part_of_way > 0 ? part_of_way * (way(a) + way(b)) : 0;
  return (separation + both) * (1 + 0x1p-40);
}

void World::State::begin() {
  statistics = {};
  for (Part* part : {&straight_, &turning_, &at_rest_}) {
    if (must_gather_) part->gathered = nullptr;
    part->pairs.clear();
  }
  must_gather_ = false;
}

std::vector<BodyPair> World::State::near_bodies(const Reach& reach, double more, bool at_start) {
  stop_if_cancelled(options);
  double farthest = reach.separation;
  if (reach.part_of_way > 0)
    for (const auto& one : bodies)
      if (one && one->is_enabled) farthest = std::max(farthest, reach.of(*one, *one));
  std::vector<BodyPair> pairs = near_bodies_.find(bodies, (farthest + more) * (1 + 0x1p-40), at_start);
  if (!kept_apart.empty()) std::erase_if(pairs, [&](const BodyPair& pair) { return kept_apart.contains(pair); });
  return pairs;
}

std::vector<BodyPair> World::State::only(const Wanted& is_wanted, std::vector<BodyPair> pairs) const {
  std::erase_if(pairs, [&](const BodyPair& pair) { return !is_wanted(*bodies[at(pair[0])], *bodies[at(pair[1])]); });
  return pairs;
}

void World::State::gather(Part& part, const Reach& reach, const Wanted& is_wanted, const std::vector<BodyPair>& near,
                          const std::vector<double>& times) {
  const auto find = [&](const std::vector<BodyPair>& pairs, double more) {
    const auto reach_of = [&](const Body& a, const Body& b) { return (reach.of(a, b) + more) * (1 + 0x1p-40); };
    return find_near_items(bodies, pairs, reach_of, times);
  };
  const NearItems needed = find(only(is_wanted, near), 0);
  part.pairs = needed.pairs;
  if (!part.is_asked()) return;
  const std::size_t count = needed.count();
  if (part.gathered && kShrunk * count >= part.needed_when_gathered && part.gathered->holds(needed, bodies)) return;
  double edges = 0;
  for (const auto& [id, unused] : needed.of_body) edges += bodies[at(id)]->shape().edge;
  const double more = kMoreInEdges * edges / static_cast<double>(needed.of_body.size());
  NearItems all = find(only(is_wanted, near_bodies(reach, more, times.back() == 0)), more);
  all.add(needed);
  const MeetingRules rules{part.aside, kept_apart};
  part.gathered = std::make_unique<Gathered>(bodies, std::move(all), rules, options);
  part.needed_when_gathered = count;
}

std::vector<double> World::State::times_of_pieces(const std::vector<BodyPair>& pairs) const {
  double pieces = 1;
  for (const BodyPair& pair : pairs) {
    const Body &a = *bodies[at(pair[0])], &b = *bodies[at(pair[1])];
    const double allowed = kDeviationInEdges * std::max(a.shape().edge, b.shape().edge);
    const double deviation = (a.acceleration() + b.acceleration()) / 8;  // of the whole step
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

template <class F>
void World::State::for_each_by_itself(const F& f) {
  for (std::size_t id = 0; id < bodies.size(); ++id) {
    Body* body = bodies[id].get();
    if (!body || !body->is_enabled || !body->deforming() || !body->may_touch_itself) continue;
    if (!body->itself) body->itself.emplace(body->shape().mesh, options);
    f(static_cast<BodyId>(id), *body);
    add_statistics(body->itself->statistics());
  }
}

/// A contact, or what ends a step.
template <class Pair>
void World::State::refuse_touching_start(const Pair& pair) const {
  const auto& [a, b] = pair.bodies;
  const std::string which =
      a == b ? "body " + std::to_string(a) : "bodies " + std::to_string(a) + " and " + std::to_string(b);
  throw InvalidStep(features_text(pair.kind, pair.vertices) + " of " + which +
                    " touch at the start, or are nearer than can be told: move them apart, keep the bodies apart by "
                    "set_may_touch, or ask with at_start ignore");
}

std::vector<BodyContact> World::State::contacts(const QueryOptions& asked) {
  validate_of_path(asked);
  std::vector<BodyContact> all;
  for_each_by_itself([&](BodyId id, Body& body) {
    for (const Contact& c : body.itself->contacts(body.step(), of_steps(asked))) all.push_back({c, twice(id)});
  });
  gather_moving({separation(asked)});
  const auto add = [&](Part& part, const std::vector<Contact>& contacts) {
    for (const Contact& c : contacts) all.push_back(named(c, *part.gathered));
    add_statistics(part.gathered->detector().statistics());
  };
  if (straight_.is_asked()) {
    Gathered& gathered = *straight_.gathered;
    const Step step = gathered.step(bodies);
    std::vector<Contact> found;
    gathered.detector().contacts(step, found, of_steps(asked));
    decide_anew(found, step, asked);
    add(straight_, found);
  }
  if (turning_.is_asked()) {
    const RigidPath path = turning_.gathered->path(bodies);
    add(turning_, DetectorMaker::ask(turning_.gathered->detector(), path, of_curves(asked), Question::all_contacts,
                                     std::span(times_).subspan(1)));
  }
  std::ranges::sort(all, is_before<BodyContact>);
  if (asked.at_start == AtStart::fail)
    for (const BodyContact& c : all)
      if (c.toi_lower == 0) refuse_touching_start(c);
  return all;
}

/// The last digits of what a detector finds depend on what else is in its mesh, which here depends on earlier
/// questions: the narrow phase knows of the pair alone. What was ignored at the start has been decided so already.
void World::State::decide_anew(std::vector<Contact>& contacts, const Step& step, const QueryOptions& asked) const {
  std::vector<Pair> pairs;
  for (const Contact& c : contacts) pairs.push_back({c.kind, c.vertices});
  PairListOptions of_list;
  of_list.min_separation = separation(asked);
  of_list.threads = options.threads;
  of_list.isa = options.isa;
  of_list.is_cancelled = options.is_cancelled;
  const std::vector<PairResult> results = narrow_phase(pairs, step, of_list);
  for (std::size_t i = 0; i < contacts.size(); ++i)
    if (asked.at_start != AtStart::ignore || results[i].toi_upper > 0)
      contacts[i] = contact_of(contacts[i].kind, contacts[i].vertices, results[i]);
}

EarliestBodyContact World::State::earliest(const QueryOptions& asked) {
  validate_of_path(asked);
  EarliestBodyContact first;
  for_each_by_itself([&](BodyId id, Body& body) {
    const EarliestContact own = body.itself->earliest(body.step(), of_steps(asked));
    take_sooner(first, own, [&] { return BodyContact{*own.contact, twice(id)}; });
  });
  gather_moving({separation(asked)});
  const auto take = [&](Part& part, const EarliestContact& found) {
    take_sooner(first, found, [&] { return named(*found.contact, *part.gathered); });
    add_statistics(part.gathered->detector().statistics());
  };
  if (straight_.is_asked()) {
    Gathered& gathered = *straight_.gathered;
    take(straight_, gathered.detector().earliest(gathered.step(bodies), of_steps(asked)));
  }
  if (turning_.is_asked()) {
    const RigidPath path = turning_.gathered->path(bodies);
    take(turning_, first_of(DetectorMaker::ask(turning_.gathered->detector(), path, of_curves(asked),
                                               Question::earliest, std::span(times_).subspan(1))));
  }
  if (asked.at_start == AtStart::fail && first.contact && first.toi_lower == 0) refuse_touching_start(*first.contact);
  return first;
}

bool World::State::is_free(const QueryOptions& asked) {
  if (asked.at_start == AtStart::fail) return !earliest(asked).contact;
  validate_of_path(asked);
  gather_moving({separation(asked)});
  bool is_free = true;
  const auto take = [&](Part& part, bool part_is_free) {
    add_statistics(part.gathered->detector().statistics());
    is_free &= part_is_free;
  };
  if (straight_.is_asked()) {
    Gathered& gathered = *straight_.gathered;
    take(straight_, gathered.detector().is_free(gathered.step(bodies), of_steps(asked)));
  }
  if (turning_.is_asked() && is_free) {
    const RigidPath path = turning_.gathered->path(bodies);
    take(turning_, DetectorMaker::ask(turning_.gathered->detector(), path, of_curves(asked), Question::is_free,
                                      std::span(times_).subspan(1))
                       .empty());
  }
  if (is_free)
    for_each_by_itself(
        [&](BodyId, Body& body) { is_free = is_free && body.itself->is_free(body.step(), of_steps(asked)); });
  return is_free;
}

std::vector<BodyNearPair> World::State::pairs_within(double distance) {
  validate_distance(distance, "the distance");
  std::vector<BodyNearPair> all;
  for_each_by_itself([&](BodyId id, Body& body) {
    for (const NearPair& pair : body.itself->pairs_within(body.deforming()->start, distance))
      all.push_back({pair, twice(id)});
  });
  gather_at_rest(distance);
  if (at_rest_.is_asked()) {
    Gathered& gathered = *at_rest_.gathered;
    for (const NearPair& pair : gathered.detector().pairs_within(gathered.start(bodies), distance)) {
      BodyNearPair one{pair, {}};
      one.bodies = gathered.name(pair.kind, one.vertices);
      all.push_back(one);
    }
    add_statistics(gathered.detector().statistics());
  }
  std::ranges::sort(all, is_before<BodyNearPair>);
  return all;
}

std::vector<BodyIntersection> World::State::intersections() {
  std::vector<BodyIntersection> all;
  for_each_by_itself([&](BodyId id, Body& body) {
    for (const Intersection& one : body.itself->intersections(body.deforming()->start)) all.push_back({one, twice(id)});
  });
  gather_at_rest(0);
  if (at_rest_.is_asked()) {
    Gathered& gathered = *at_rest_.gathered;
    for (const Intersection& one : gathered.detector().intersections(gathered.start(bodies)))
      all.push_back(gathered.named(one));
    add_statistics(gathered.detector().statistics());
  }
  std::ranges::sort(all, [](const auto& a, const auto& b) {
    return std::tie(a.bodies[0], a.edge, a.bodies[1], a.face) < std::tie(b.bodies[0], b.edge, b.bodies[1], b.face);
  });
  return all;
}

/// A pair that starts at the distance d, beyond the separation, and keeps no more than f d has come f w / (1 - f) near,
/// w being how far both bodies go.
BodyStep World::State::safe_step(double fraction, const QueryOptions& asked) {
  validate_kept(fraction);
  validate_of_path(asked);
  gather_moving({separation(asked), fraction / (1 - fraction)});
  BodyStep first;
  const auto add = [&](const SafeStep& step, const auto& name) {
    first.upper = std::min(first.upper, step.upper);
    if (!step.pair || step.lower > first.lower) return;
    BodyStep::Pair named{*step.pair, {}};
    named.bodies = name(named);
    if (first.pair && step.lower == first.lower && !is_before(named, *first.pair)) return;
    first.lower = step.lower;
    first.pair = named;
  };
  for_each_by_itself([&](BodyId id, Body& body) {
    add(body.itself->safe_step(body.step(), fraction, of_steps(asked)), [&](auto&) { return twice(id); });
  });
  const auto add_gathered = [&](Gathered& gathered, const SafeStep& step) {
    add(step, [&](auto& pair) { return gathered.name(pair.kind, pair.vertices); });
    add_statistics(gathered.detector().statistics());
  };
  if (straight_.is_asked()) {
    Gathered& gathered = *straight_.gathered;
    add_gathered(gathered, gathered.detector().safe_step(gathered.step(bodies), fraction, of_steps(asked)));
  }
  if (turning_.is_asked()) {
    Gathered& gathered = *turning_.gathered;
    add_gathered(gathered, DetectorMaker::safe_step(gathered.detector(), gathered.path(bodies), fraction,
                                                    of_curves(asked), std::span(times_).subspan(1)));
  }
  if (asked.at_start == AtStart::fail && first.pair && first.lower == 0) refuse_touching_start(*first.pair);
  return first;
}

void World::State::add_statistics(const Statistics& of_part) {
  statistics.isa = of_part.isa;
  statistics.threads = std::max(statistics.threads, of_part.threads);
  for (const StageCount& stage : of_part.stages) {
    const auto same = std::ranges::find(statistics.stages, stage.name, &StageCount::name);
    if (same == statistics.stages.end())
      statistics.stages.push_back(stage);
    else
      tamis::add(*same, stage);
  }
  statistics.decided_by += of_part.decided_by;
  statistics.seconds += of_part.seconds;
  statistics.ignored += of_part.ignored;
  statistics.nodes_visited += of_part.nodes_visited;
  statistics.rebuilt |= of_part.rebuilt;
}

std::uint64_t World::State::memory_bytes() const {
  std::uint64_t bytes = 0;
  for (const auto& body : bodies)
    if (body) bytes += body->memory_bytes();
  for (const Part* part : {&straight_, &turning_, &at_rest_})
    if (part->gathered) bytes += part->gathered->memory_bytes();
  return bytes;
}

}  // namespace tamis
