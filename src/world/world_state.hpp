// What a world keeps from question to question, and how each is answered: bodies that are near each other are found,
// what may touch of them is gathered, and detectors are asked.
#pragma once
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "detect/detector_access.hpp"
#include "detect/validate.hpp"
#include "numerics/error_bounds.hpp"
#include "numerics/held_bytes.hpp"
#include "query/stopwatch.hpp"
#include "tamis/error.hpp"
#include "tamis/turn.hpp"
#include "world/gathered.hpp"

namespace tamis {

struct World::State {
  explicit State(Options o);
  /// The same bodies, to be asked by one thread. Nothing is gathered yet.
  State(const State& other);

  Body& body(BodyId id);
  void move(BodyId id, BodyMotion motion);
  /// Of a body of which something else than its motion has changed, or that goes: what was gathered is of no use.
  void forget_gathered(const Body& changed);
  /// Of a body that comes, or gets another motion: what is gathered sees that itself.
  void forget_if_still(const Body& changed) {
    if (changed.motion_kind() == MotionKind::still) near_bodies_.forget_still();
  }

  const Options options;
  BodyList bodies;
  std::set<BodyPair> kept_apart;
  Statistics statistics;
  std::atomic_flag is_asked;

  /// What `ask`, a function of the state, returns of these; one at a time.
  template <class Ask, class... Of>
  auto answer(const Ask& ask, const Of&... of) {
    const Turn turn(is_asked);
    statistics = {};
    begin();
    const Stopwatch watch;
    auto result = std::invoke(ask, *this, of...);
    statistics.seconds.total = watch.seconds();
    statistics.memory_bytes = memory_bytes();
    return result;
  }
  std::vector<BodyContact> contacts(const QueryOptions& asked);
  EarliestBodyContact earliest(const QueryOptions& asked);
  std::vector<EarliestBodyContact> earliest_many(std::span<const BodyId> moved, std::span<const BodyMotion> motions,
                                                 const QueryOptions& asked);
  bool is_free(const QueryOptions& asked);
  std::vector<BodyNearPair> pairs_within(double distance);
  std::vector<BodyIntersection> intersections();
  bool has_intersection();
  BodyStep safe_step(double fraction, const QueryOptions& asked);

 private:
  /// How near bodies must come to be asked about: within the separation, both radii, and a part of how far both go.
  struct Reach {
    double separation = 0;
    double part_of_way = 0;
    /// What one of them adds.
    double own(const Body& body) const;
    double of(const Body& a, const Body& b) const { return (separation + own(a) + own(b)) * kRoundedUp; }
  };
  /// What was gathered is all that comes within the reach and `more`. It serves later questions while both bodies of
  /// each pair together are no farther than `more` from where they were then, at the same time of the step.
  struct Margin {
    double separation, more;
    std::map<BodyId, StraightWay> ways;
    bool has(const BodyList& of_world, const std::vector<BodyPair>& pairs) const;
    std::uint64_t memory_bytes() const { return held_bytes(ways); }
  };
  /// One mesh of bodies that meet: those whose vertices all go straight, those of which one turns, or at rest all.
  struct Gathering {
    bool (*wants)(const Body&, const Body&);  ///< is it asked about such a pair?
    MotionKind aside;                         ///< as in MeetingRules
    /// What is gathered is more than what may touch now, by so many mean edges: it serves the questions that follow.
    /// More where these are answered without a search (Margin).
    double more_in_edges;
    std::unique_ptr<Gathered> gathered = nullptr;
    std::size_t needed_when_gathered = 0;         ///< items
    bool is_asked = false;                        ///< may any pair touch in this question?
    std::optional<Margin> margin = std::nullopt;  ///< of bodies that do not turn
    int served = 0, searched = 0;                 ///< questions, and those that its margin did not serve
    bool serves(const BodyList& of_world, const std::vector<BodyPair>& near, const Reach& reach) const {
      return gathered && margin && reach.part_of_way == 0 && reach.separation <= margin->separation &&
             gathered->keeps_motion_kinds(of_world) && margin->has(of_world, near);
    }
  };

  static bool is_turning(const Body& a, const Body& b) {
    return a.motion_kind() == MotionKind::turning || b.motion_kind() == MotionKind::turning;
  }
  static bool is_straight(const Body& a, const Body& b) { return !is_turning(a, b); }
  static bool is_any(const Body&, const Body&) { return true; }

  /// Throws InvalidOptions and InvalidStep.
  void validate(std::span<const BodyId> moved, std::span<const BodyMotion> motions);
  /// Pairs that may come within the reach and `more`, by their hulls, and may touch.
  std::vector<BodyPair> near_bodies(const Reach& reach, double more, bool at_start);
  std::vector<BodyPair> only(const Gathering& gathering, std::vector<BodyPair> pairs) const;
  /// `near`: those without more. `times`: the ends of pieces.
  void gather(Gathering& gathering, const Reach& reach, const std::vector<BodyPair>& near,
              std::span<const double> times);
  /// Adds to `items` what comes within the reach and `more`.
  void find_near(const std::vector<BodyPair>& pairs, const Reach& reach, double more, Pieces& pieces,
                 NearItems& items) const;
  void gather_anew(Gathering& gathering, const Reach& reach, const NearItems& needed, Pieces& pieces);
  /// None where one of them turns.
  std::optional<Margin> margin_of(const std::vector<BodyPair>& pairs, const Reach& reach, double more) const;
  /// Those of bodies that move.
  void gather_moving(const Reach& reach);
  /// Ends of the pieces on which bodies that turn are asked about, beginning with 0.
  std::vector<double> times_of_pieces(const std::vector<BodyPair>& pairs) const;
  /// ask(state of a detector, motion, options, whose) of all that may touch, until one returns false: of what is
  /// gathered that goes straight, a Step; of what is that turns, a CutPath; of each body by itself, by its number.
  /// `part_of_way`: as in Reach. Throws InvalidOptions.
  template <class Ask>
  void for_each_moving(const QueryOptions& asked, double part_of_way, const Ask& ask);
  /// ask(state of a detector, pose, whose) of all that comes within the distance at the start, until one returns false.
  template <class Ask>
  void for_each_at_rest(double distance, const Ask& ask);
  /// f(id, body) of each that may touch itself, until one returns false.
  template <class F>
  void for_each_by_itself(const F& f);
  /// What `ask` returns of a detector's state and these.
  template <class Ask, class... Of>
  bool ask_one(Detector& detector, const Ask& ask, const Of&... of);
  void add_statistics(const Statistics& of_part);
  /// Of bodies that were refused as one path: throws InvalidPath, naming the first that goes far.
  void refuse_far(const Gathered& gathered) const;
  /// Throws InvalidStep of a contact, or a pair that ends a step, at the time 0: if that is asked for.
  template <class Row>
  static void check_start(const Row& row, double time, const QueryOptions& asked) {
    if (asked.at_start == AtStart::fail && time == 0) refuse_touching_start(row.kind, row.vertices, row.bodies);
  }
  [[noreturn]] static void refuse_touching_start(PairKind kind, const PairVertices& vertices,
                                                 const std::array<BodyId, 2>& of);
  void begin();
  std::uint64_t memory_bytes() const;

  ChainsAt at_start_{0}, at_end_{1};  ///< of what is moved
  NearBodies near_bodies_{options.isa};
  Gathering straight_{is_straight, MotionKind::still, 1}, turning_{is_turning, MotionKind::straight, 0.5},
      at_rest_{is_any, MotionKind::still, 1};
  std::vector<double> times_;  ///< of the pieces of turning_
  bool must_gather_ = false;
};

/// As bodies are asked about curves. Whoever fails for what touches at the start asks for it, and names the bodies.
inline QueryOptions of_curves(QueryOptions asked) {
  if (asked.at_start == AtStart::fail) asked.at_start = AtStart::report;
  return asked;
}
/// As bodies are asked that go straight: curves alone have a tolerance.
inline QueryOptions of_steps(const QueryOptions& asked) {
  QueryOptions options = of_curves(asked);
  options.tolerance.reset();
  return options;
}

template <class Ask, class... Of>
bool World::State::ask_one(Detector& detector, const Ask& ask, const Of&... of) {
  const auto state = DetectorAccess::lock(detector);
  const bool goes_on = ask(state, of...);
  add_statistics(state->statistics);
  return goes_on;
}

template <class F>
void World::State::for_each_by_itself(const F& f) {
  for (std::size_t id = 0; id < bodies.size(); ++id) {
    Body* body = bodies[id].get();
    if (!body || !body->is_enabled || !body->deforming() || !body->may_touch_itself) continue;
    if (!f(static_cast<BodyId>(id), *body)) return;
  }
}

template <class Ask>
void World::State::for_each_moving(const QueryOptions& asked, double part_of_way, const Ask& ask) {
  validate_of_path(asked);
  gather_moving({asked.min_separation.value_or(options.min_separation), part_of_way});
  const auto ask_straight = [&](Gathered& gathered) {
    return ask_one(gathered.detector(), ask, gathered.step(bodies), of_steps(asked), gathered);
  };
  const auto ask_turning = [&](Gathered& gathered) {
    try {
      const RigidPath path = gathered.path(bodies);
      return ask_one(gathered.detector(), ask, CutPath{path, std::span(times_).subspan(1)}, of_curves(asked), gathered);
    } catch (const InvalidPath&) {
      refuse_far(gathered);
      throw;
    }
  };
  if (straight_.is_asked && !ask_straight(*straight_.gathered)) return;
  if (turning_.is_asked && !ask_turning(*turning_.gathered)) return;
  for_each_by_itself(
      [&](BodyId id, Body& body) { return ask_one(body.itself(options), ask, body.step(), of_steps(asked), id); });
}

template <class Ask>
void World::State::for_each_at_rest(double distance, const Ask& ask) {
  constexpr double kEndsOfRest[] = {0, 0};
  const Reach reach{distance};
  gather(at_rest_, reach, near_bodies(reach, 0, true), kEndsOfRest);
  if (at_rest_.is_asked) {
    Gathered& gathered = *at_rest_.gathered;
    if (!ask_one(gathered.detector(), ask, gathered.start(bodies), gathered)) return;
  }
  for_each_by_itself([&](BodyId id, Body& body) {
    return ask_one(body.itself(options), ask, Positions(body.deforming()->start), id);
  });
}

}  // namespace tamis
