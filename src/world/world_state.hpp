// What a world keeps from question to question, and how each is answered: bodies that are near each other are found,
// what may touch of them is gathered, and detectors are asked.
#pragma once
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "query/stopwatch.hpp"
#include "tamis/turn.hpp"
#include "world/gathered.hpp"

namespace tamis {

struct World::State {
  explicit State(Options o);
  /// The same bodies, to be asked by one thread. Nothing is gathered yet.
  State(const State& other);

  Body& body(BodyId id);
  void move(BodyId id, BodyMotion motion);
  /// What was gathered with this body must not be asked any more.
  void forget(const Body& changed);
  /// Of a body that comes, or moves on: what is gathered sees that itself.
  void forget_if_still(const Body& changed) {
    if (changed.way() == Way::still) near_bodies_.forget_still();
  }

  const Options options;
  BodyList bodies;
  std::set<BodyPair> kept_apart;
  Statistics statistics;
  std::atomic_flag is_asked;

  /// What ask() returns; one at a time.
  template <class Ask>
  auto answer(const Ask& ask) {
    const Turn turn(is_asked);
    statistics = {};
    begin();
    const Stopwatch watch;
    auto result = ask();
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
  BodyStep safe_step(double fraction, const QueryOptions& asked);

 private:
  /// How near bodies must come to be asked about.
  struct Reach {
    double separation = 0;
    double part_of_way = 0;  ///< and so much of how far both go, and both radii
    /// What one of them adds.
    double own(const Body& body) const;
    double of(const Body& a, const Body& b) const { return (separation + own(a) + own(b)) * (1 + 0x1p-40); }
  };
  /// What was gathered is all that comes within the reach and `more`: it serves as long as bodies keep so near to the
  /// ways that they went then.
  struct Room {
    double separation, more;
    std::map<BodyId, StraightWay> ways;
    bool has(const BodyList& of_world, const std::vector<BodyPair>& pairs) const;
  };
  /// One mesh of bodies that meet: those whose vertices all go straight, those of which one turns, or at rest all.
  struct Part {
    Way aside;
    std::unique_ptr<Gathered> gathered = nullptr;
    std::size_t needed_when_gathered = 0;
    std::vector<BodyPair> pairs = {};         ///< those that may touch in this question
    std::optional<Room> room = std::nullopt;  ///< of bodies that do not turn
    bool is_asked() const { return !pairs.empty(); }
    bool serves(const BodyList& of_world, const std::vector<BodyPair>& near, const Reach& reach) const {
      return gathered && room && reach.part_of_way == 0 && reach.separation <= room->separation &&
             gathered->keeps_ways(of_world) && room->has(of_world, near);
    }
  };

  /// Which pairs a part is asked about.
  using Wanted = std::function<bool(const Body&, const Body&)>;

  /// Throws InvalidOptions and InvalidStep.
  void validate(std::span<const BodyId> moved, std::span<const BodyMotion> motions);
  double separation(const QueryOptions& asked) const { return asked.min_separation.value_or(options.min_separation); }
  /// Pairs that may come within the reach and `more`, by their hulls, and may touch.
  std::vector<BodyPair> near_bodies(const Reach& reach, double more, bool at_start);
  std::vector<BodyPair> only(const Wanted& is_wanted, std::vector<BodyPair> pairs) const;
  /// `near`: those without more. `times`: as find_near_items has them.
  void gather(Part& part, const Reach& reach, const Wanted& is_wanted, const std::vector<BodyPair>& near,
              const std::vector<double>& times);
  /// None where one of them turns.
  std::optional<Room> room_of(const std::vector<BodyPair>& pairs, const Reach& reach, double more) const;
  /// Those of bodies that move.
  void gather_moving(const Reach& reach);
  void gather_at_rest(double distance);
  /// Ends of the pieces on which bodies that turn are asked about, beginning with 0.
  std::vector<double> times_of_pieces(const std::vector<BodyPair>& pairs) const;
  /// f(id, body, detector) of each body that may touch itself.
  template <class F>
  void for_each_by_itself(const F& f);
  void add_statistics(const Statistics& of_part);
  /// Of a contact, or of what ends a step.
  [[noreturn]] void refuse_touching_start(PairKind kind, const PairVertices& vertices,
                                          const std::array<BodyId, 2>& of) const;
  /// Throws InvalidStep, if that is asked for.
  void check_start(const EarliestBodyContact& first, const QueryOptions& asked) const;
  void begin();
  std::uint64_t memory_bytes() const;

  NearBodies near_bodies_;
  Part straight_{Way::still}, turning_{Way::straight}, at_rest_{Way::still};
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

template <class F>
void World::State::for_each_by_itself(const F& f) {
  for (std::size_t id = 0; id < bodies.size(); ++id) {
    Body* body = bodies[id].get();
    if (!body || !body->is_enabled || !body->deforming() || !body->may_touch_itself) continue;
    f(static_cast<BodyId>(id), *body, body->itself(options));
    add_statistics(body->itself(options).statistics());
  }
}

}  // namespace tamis
