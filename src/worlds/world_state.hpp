// The state that a world keeps from question to question, and the functions that answer questions. They find near
// bodies, gather the items of these that may touch (worlds/gathering.hpp), and query detectors.
#pragma once
#include <optional>
#include <set>
#include <vector>

#include "numbers/busy_guard.hpp"
#include "numbers/floating_point_state.hpp"
#include "search/query/stopwatch.hpp"
#include "tamis/linkage.hpp"
#include "worlds/gathering.hpp"

namespace tamis {

struct World::State {
  explicit State(Options o);
  /// A copy of the bodies, for the questions of one thread. Nothing is gathered yet.
  State(const State& other);

  Body& body(BodyId id);
  // Changes of one or many bodies. All of it is computed before any of it is done.

  std::vector<BodyId> add(const std::shared_ptr<const BodyShape>& shape, std::vector<BodyMotion> motions);
  void move(BodyId id, BodyMotion motion);
  void move(std::span<const BodyId> ids, std::vector<BodyMotion> motions);
  void set_may_touch(std::span<const BodyPair> pairs, bool may_touch);
  /// Drops the gathered meshes. Called when a body is removed, or when anything of it but its motion has changed.
  void forget_gathered(const Body& changed);
  /// To be called when a body is added or given another motion. Gathered meshes notice both by themselves.
  void forget_if_still(const Body& changed) {
    if (changed.motion_kind() == MotionKind::still) still_.reset();
  }

  const Options options;
  BodyList bodies;
  std::set<BodyPair> excluded_pairs;  ///< may not touch, by set_may_touch
  /// If given, questions are about these pairs alone. Ascending. All pairs of them that may touch are among them.
  const std::vector<BodyPair>* only_pairs = nullptr;
  Statistics statistics;
  std::atomic_flag is_asked;

  class Turn;
  class QuestionTurn;
  class Edges;
  struct EdgeTesters;
  bool is_free(const PathOptions& asked);
  EarliestBodyContact earliest(const PathOptions& asked);
  /// Two bodies that pass through each other at t=0, or of which one is inside the other. Any such pair.
  std::optional<BodyPair> overlapping_pair(const PoseOptions& asked);
  /// The first such pair if `question` is all_contacts, any if it is is_free.
  std::optional<BodyPair> intersecting_pair(const PoseOptions& asked, Question question);
  /// Two bodies of which one encloses a part of the other. Finds all such bodies only where there is no intersection.
  std::optional<BodyPair> enclosing_pair(const PoseOptions& asked);
  /// Calls test(Edges&, i) for each edge. Threads share them. Throws InvalidOptions, and what `test` throws.
  template <class Test>
  void for_each_edge(const std::shared_ptr<const LinkageTree>& tree, std::size_t count, const EdgeOptions& how,
                     const Test& test);
  /// Throws InvalidOptions.
  /// Whether no body moves but those of the linkage.
  bool others_stay(const LinkageTree& tree) const;
  static void refuse_uneven(std::size_t starts, std::size_t ends);

  void become(Body& body, Body moved) noexcept;
  void drop_gathered();
  /// Throws InvalidOptions.
  void require_may_touch(BodyId a, BodyId b, bool may_touch);
  /// Throws InvalidOptions if a body is named twice.
  static void refuse_twice(std::span<const BodyId> ids);
  /// Throws InvalidOptions and InvalidStep.
  void validate(std::span<const BodyId> moved, std::span<const BodyMotion> motions);
  /// Pairs of bodies that may touch, ascending, both switched on, whose hulls come within the distance. Two bodies that
  /// stay are a pair only with `include_static`.
  std::vector<BodyPair> near_bodies(const NearDistance& distance);
  std::vector<BodyPair> wanted_pairs(const Gathering& gathering, std::vector<BodyPair> pairs) const;
  /// Makes `gathering` hold all items that come within the distance. Returns false if none do. `seen`: `bodies`, or
  /// those that a frame sees. `pairs`: wanted_pairs() of near_bodies(), or those of the frame. REQUIRES: no margin.
  /// `times`: the ends of pieces, beginning with 0.
  bool gather(Gathering& gathering, const BodyList& seen, const NearDistance& distance,
              const std::vector<BodyPair>& pairs, std::span<const double> times);
  void gather_anew(Gathering& gathering, const BodyList& seen, const std::vector<BodyPair>& near, NearDistance distance,
                   const NearItems& needed, std::span<const double> times);
  /// Ends of the pieces for questions about bodies that turn, beginning with 0.
  static std::vector<double> times_of_pieces(const BodyList& seen, const std::vector<BodyPair>& pairs,
                                             const NearDistance& distance);
  /// Queries pairs with a body that turns, in the world or in a frame (`seen`, as for gather()). Returns false if no
  /// more queries are needed.
  template <class Ask>
  bool ask_turning(Gathering& gathering, const BodyList& seen, const RigidChain& carrier,
                   const std::vector<BodyPair>& pairs, const NearDistance& distance, const PathOptions& asked,
                   const Ask& ask);
  /// Calls ask(state of a detector, motion, options, whose) for each detector, until one call returns false. Bodies
  /// that go straight have a Step. Pairs with a body that turns have a CutPath, one more in each frame of bodies that
  /// turn together. Each deforming body has its Step and its number. `displacement_factor`: as in NearDistance. Throws
  /// InvalidOptions.
  template <class Ask>
  void for_each_moving(const PathOptions& asked, double displacement_factor, const Ask& ask);
  /// The same in the pose at t=0, for all items that come within the distance: ask(state of a detector, pose, whose).
  template <class Ask>
  void for_each_at_rest(double distance, const PoseOptions& asked, const Ask& ask);
  /// Calls f(id, body) for each body that may touch itself, until one returns false.
  template <class F>
  void for_each_by_itself(const F& f);
  /// Queries one detector, and adds its statistics.
  template <class Ask, class... Of>
  bool ask_one(Detector& detector, const Ask& ask, const Of&... of);
  void add_statistics(const Statistics& of_part);
  /// Throws InvalidPath if a gathered body's numbers are too large, naming the first such body.
  void refuse_far(const Gathered& gathered) const;
  /// Throws InvalidStep with AtStart::fail if the pair touches, or ends the step, at the time 0.
  template <class Row>
  static void check_start(const Row& row, double time, const PathOptions& asked) {
    if (asked.at_start == AtStart::fail && time == 0) refuse_touching_start(row.kind, row.vertices, row.bodies);
  }
  [[noreturn]] static void refuse_touching_start(PairKind kind, const PairVertices& vertices,
                                                 const std::array<BodyId, 2>& of);
  std::uint64_t memory_bytes() const;

  std::optional<BodyTree> still_;  ///< of the bodies that stay, once asked for
  Gathering straight_{MotionKind::straight, MotionKind::straight, 1};
  Gathering turning_{MotionKind::turning, MotionKind::turning, 0.5};
  Gathering at_rest_{MotionKind::straight, MotionKind::turning, 1};
  Gathering at_rest_with_static_{MotionKind::still, MotionKind::turning, 1};
  std::map<std::pair<std::size_t, BodyId>, Gathering> carried_;  ///< by the number of shared links and the first body
  std::uint64_t turns_ = 0;                                      ///< which may have changed something
  std::shared_ptr<EdgeTesters> edge_testers_;                    ///< of the last question about edges
};

/// A detector's options for questions about curves. With AtStart::fail contacts at the start are reported. The world
/// refuses them, naming bodies.
inline PathOptions of_curves(PathOptions asked) {
  if (asked.at_start == AtStart::fail) asked.at_start = AtStart::report;
  return asked;
}

/// The state, for as long as one change or question has its turn.
class World::State::Turn {
 public:
  /// Throws Busy, and Error of a world that has been moved from.
  explicit Turn(const World& world) : Turn(world, true) {}
  Turn(const Turn&) = delete;
  State* operator->() const { return &state_; }
  State& operator*() const { return state_; }

 protected:
  Turn(const World& world, bool may_change) : state_(world.state()), guard_(state_.is_asked) {
    if (may_change) ++state_.turns_;
  }

 private:
  State& state_;
  const BusyGuard guard_;
  const ComputingState computing_;
};

/// The turn of a question, which is measured.
class World::State::QuestionTurn : public Turn {
 public:
  explicit QuestionTurn(const World& world) : Turn(world, false) { (*this)->statistics = {}; }
  ~QuestionTurn() {
    (*this)->statistics.seconds.total = watch_.seconds();
    (*this)->statistics.memory_bytes = (*this)->memory_bytes();
  }

 private:
  const Stopwatch watch_;
};

}  // namespace tamis
