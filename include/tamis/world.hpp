// A world of bodies, each with its own mesh and its own way of moving: what does not deform costs nothing to keep.
#pragma once
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "tamis/contact.hpp"
#include "tamis/mesh.hpp"
#include "tamis/options.hpp"
#include "tamis/proximity.hpp"
#include "tamis/rigid_path.hpp"
#include "tamis/statistics.hpp"

namespace tamis {

struct BodyShape;

/// A mesh with its points at rest, in the body's own frame, and the hierarchy over them: made once, then shared by any
/// number of bodies. Copies share it, and what is moved from is copied: it still has its own.
class Shape {
 public:
  /// `points`: one row a vertex. `isa`: of what makes the hierarchy; speed only, as in Options. Throws InvalidMesh
  /// unless the points fit the mesh and those of Mesh::points() are finite, InvalidOptions if this machine lacks the
  /// set.
  Shape(Mesh mesh, std::vector<Point> points, Isa isa = Isa::best);
  Shape(const Shape&) = default;
  Shape& operator=(const Shape&) = default;

  const Mesh& mesh() const;
  const std::vector<Point>& points() const;
  /// Held beside mesh and points.
  std::uint64_t memory_bytes() const;

 private:
  friend class World;
  std::shared_ptr<const BodyShape> shape_;
};

/// Stays where it is. Two static bodies are never asked about.
struct Static {
  Pose pose = {};
};

/// Moves as a whole, by a chain of links (tamis/rigid_path.hpp: `interpolated`, `turned`, `between`). Where no rotation
/// of the chain changes, each vertex goes straight, from where its start is rounded to in doubles to where its end is.
/// In one step the links together turn by no more than 4096 radians, and no rotation vector, of a static body neither,
/// is longer than 2^32 (docs/worlds.md, "How far a body may turn").
struct Rigid {
  Chain chain;
};

/// Each vertex goes straight from `start` (t=0) to `end` (t=1), in the frame of the world. May touch itself.
struct Deforming {
  std::vector<Point> start, end;
};

using BodyMotion = std::variant<Static, Rigid, Deforming>;

/// Names a body of one world: 0, 1, 2, ... in the order of World::add; never given twice.
using BodyId = Index;

/// What a Detector says of a pair, said of two bodies: vertices are those of the bodies' own meshes, first those of the
/// feature of `bodies[0]`, then those of the feature of `bodies[1]`. The bodies are in the order of the features
/// (Contact): of edge_edge, of one that is smaller first.
struct BodyContact : Contact {
  std::array<BodyId, 2> bodies;
};
struct BodyNearPair : NearPair {
  std::array<BodyId, 2> bodies;
};
/// `bodies`: of the edge and of the face.
struct BodyIntersection : Intersection {
  std::array<BodyId, 2> bodies;
};
struct EarliestBodyContact {
  double toi_lower = 1;  ///< as in EarliestContact
  double toi_upper = 1;
  std::optional<BodyContact> contact;
};
/// Where the vertices of a body are at one time.
struct BodyPoints {
  std::vector<Point> points;  ///< one a vertex of its shape
  double error = 0;           ///< no coordinate of a vertex of a feature is off by more
};
struct BodyStep {
  double lower = 1;  ///< as in SafeStep
  double upper = 1;
  std::optional<BodyNearPair> pair;
};

/// Bodies, and the questions of a Detector about them: each moves during t in [0,1] as it was told last. Pairs of
/// bodies that are far from each other cost next to nothing, whatever their meshes. What may touch of the others is
/// gathered, and goes to detectors that the world keeps: one for each deforming body by itself, one for bodies that
/// meet while all their vertices go straight, one for those of which one turns. So what is proven of a Step and of a
/// Path is proven here. One question or change at a time: Busy otherwise. The answers do not depend on the number of
/// threads, on the instruction set, or on earlier questions.
class World {
 public:
  /// Of the options `threads`, `min_separation`, `isa`, `is_cancelled`, and of the filter `rings` count; all else is
  /// said by body. Throws InvalidOptions: also for an instruction set that this machine lacks.
  explicit World(Options options = {});
  ~World();
  World(World&&) noexcept;
  World& operator=(World&&) noexcept;

  /// Throws InvalidStep: a deforming body with other than one point a vertex of the shape, at each end; numbers that
  /// are not finite; a body that turns too far.
  BodyId add(const Shape& shape, BodyMotion motion);
  /// It may also begin to move in another way. Throws as `add`, and as all that names a body InvalidOptions where the
  /// world has no such body, or has it no more.
  void move(BodyId body, BodyMotion motion);
  /// As it was told last; valid until the next change of the world.
  const BodyMotion& motion(BodyId body) const;
  /// Where its vertices are at `time` in [0,1] of that motion, on the curves that questions are about: at a contact's
  /// time, to draw it or to work out a response. With the error 0 these are the very points. Throws InvalidOptions.
  BodyPoints points_at(BodyId body, double time) const;
  void remove(BodyId body);
  /// A body that is switched off takes no part in any question until it is switched on again; bodies begin switched on.
  void set_enabled(BodyId body, bool is_enabled);
  /// Half of its thickness, in the unit of the positions: bodies are in contact where their distance is at most the
  /// minimum separation plus both radii, for every question but `intersections`; so is a deforming one with itself.
  /// At first 0. Throws InvalidOptions: negative or not finite; a question does where sums are more than any double.
  void set_radius(BodyId body, double radius);
  /// Two bodies, or a deforming body with itself: may they touch at all? At first all may; two static bodies never, nor
  /// a body that does not deform itself. Throws InvalidOptions: one of these is asked for.
  void set_may_touch(BodyId a, BodyId b, bool may_touch);

  /// All contacts, by kind, then bodies and vertices in the order of the features. Where one of two bodies turns, these
  /// are answers about a Path (Detector): some may be unresolved, QueryOptions::tolerance counts, and AtStart::ignore
  /// leaves a pair out until one of the times that docs/worlds.md names proves it apart. Throws InvalidOptions, and
  /// with AtStart::fail InvalidStep.
  std::vector<BodyContact> contacts(const QueryOptions& = {});
  EarliestBodyContact earliest(const QueryOptions& = {});
  /// As of a planner, from configuration to configuration: `earliest` for each of many motions of some bodies, while
  /// all others move as they were told. `motions`: one for each of `bodies`, in their order, then again for the next
  /// motion. Threads share the motions, each with a copy of the world's bodies; each answer has the bits that it has
  /// alone. The bodies themselves go on moving as they were told. Throws InvalidOptions: a body that is not there, or
  /// is named twice, a number of motions that is no multiple; InvalidStep as `add`, naming the motion.
  std::vector<EarliestBodyContact> earliest_many(std::span<const BodyId> bodies, std::span<const BodyMotion> motions,
                                                 const QueryOptions& = {});
  bool is_free(const QueryOptions& = {});

  /// Where all bodies are at t=0, rounded to doubles: pairs of features within `distance` plus both radii, in the same
  /// order. Two bodies that are Static are left out here and of the next two questions, even where they pass through
  /// each other: before the first step tell them Rigid{interpolated(pose, pose)}, ask, and tell them Static again.
  std::vector<BodyNearPair> pairs_within(double distance);
  /// Edges that pass through triangles there, by bodies, edge and face; not of two Static bodies (`pairs_within`).
  std::vector<BodyIntersection> intersections();
  /// Are there any? Not of two Static bodies. Ends at the first.
  bool has_intersection();

  /// How far all may go, as Detector::safe_step. Where one of two bodies turns, QueryOptions::tolerance counts, and a
  /// pair that starts nearer to its separation than doubles can tell ends the step at once.
  BodyStep safe_step(double keep = 0.1, const QueryOptions& = {});

  /// Of the last question: sums over the detectors that it asked; `memory_bytes` without shapes. Throws Busy during
  /// one.
  const Statistics& statistics() const;

 private:
  struct State;
  State& state() const;
  std::unique_ptr<State> state_;
};

}  // namespace tamis
