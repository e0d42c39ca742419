// A world of bodies, each with its own mesh and motion. Bodies that do not deform cost nothing to keep.
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
class Linkage;

/// A mesh with its points at rest, in the body's own frame, and the hierarchy over them. Made once, then shared by any
/// number of bodies. Copies share all of it. Moving copies: the source keeps it.
class Shape {
 public:
  /// Builds the hierarchy. `points`: one row a vertex. `isa`: the instruction set; changes speed only, as in Options.
  /// Throws InvalidMesh unless there is one point a vertex and the points of Mesh::points() are finite. Throws
  /// InvalidOptions if this machine lacks the instruction set.
  Shape(Mesh mesh, std::vector<Point> points, Isa isa = Isa::best);
  /// Shares the copied shape's mesh, points and hierarchy.
  Shape(const Shape&) = default;
  /// Shares the copied shape's mesh, points and hierarchy.
  Shape& operator=(const Shape&) = default;

  /// Returns the mesh.
  [[nodiscard]] const Mesh& mesh() const;
  /// Returns the points at rest.
  [[nodiscard]] const std::vector<Point>& points() const;
  /// Returns the memory that the shape holds besides mesh and points.
  [[nodiscard]] std::uint64_t memory_bytes() const;

 private:
  friend class World;
  std::shared_ptr<const BodyShape> shape_;
};

/// The body stays at its pose. Questions skip two static bodies, unless PoseOptions::include_static is set.
struct Static {
  Pose pose = {};  ///< where the body stays
};

/// The body moves as a whole, by a chain of links (tamis/rigid_path.hpp: `interpolated_chain`, `turned_chain`,
/// `chain_between`). If no rotation of the chain changes, each vertex goes straight, from its start rounded to doubles
/// to its end rounded to doubles. In one step the links together turn by no more than 4096 radians. No rotation vector,
/// not even of a static body, is longer than 2^32 (docs/worlds.md, "How far a body may turn"). Bodies whose chains
/// begin with equal links move relative to each other by the links behind these alone. To a body that a gripper holds,
/// give the gripper's links, then a constant one.
struct Rigid {
  RigidChain chain;  ///< outermost link first
};

/// Each vertex goes straight from `start` (t=0) to `end` (t=1), in the frame of the world. The body may touch itself.
struct Deforming {
  std::vector<Point> start;  ///< positions at t=0, one a vertex of the shape
  std::vector<Point> end;    ///< positions at t=1
};

/// How a body moves during the step.
using BodyMotion = std::variant<Static, Rigid, Deforming>;

/// The number of a body in its world: 0, 1, 2, ... in the order of World::add. Never given twice.
using BodyId = Index;

/// A contact of two bodies. Its vertices are numbered in the bodies' own meshes. They are first the vertices of the
/// feature of `bodies[0]`, then of the feature of `bodies[1]`. The features are in the order of Contact. Of two edges
/// the edge of the body with the smaller number is first.
struct BodyContact : Contact {
  std::array<BodyId, 2> bodies;  ///< the first feature's body, then the second's
};
/// A near pair of two bodies. Vertices as in BodyContact.
struct BodyNearPair : NearPair {
  std::array<BodyId, 2> bodies;  ///< the first feature's body, then the second's
};
/// An intersection of two bodies. Vertices are numbered in the bodies' own meshes.
struct BodyIntersection : Intersection {
  std::array<BodyId, 2> bodies;  ///< the edge's body, then the face's
};
/// The first contact of all bodies.
struct EarliestBodyContact {
  double toi_lower = 1;                ///< as in EarliestContact
  double toi_upper = 1;                ///< as in EarliestContact
  std::optional<BodyContact> contact;  ///< the contact that ends the step; none if the step is free
};
/// Positions of the vertices of a body at one time.
struct BodyPoints {
  std::vector<Point> points;  ///< one a vertex of its shape
  double error = 0;           ///< no coordinate of a vertex in Mesh::points() is off by more than this
};
/// Options of questions about edges between configurations of a linkage.
struct EdgeOptions {
  std::optional<double> min_separation = {};  ///< as in QueryOptions: free means farther apart, all along the edge
  double tolerance = 1e-9;                    ///< as in PathOptions, in fractions of the edge
  bool starts_are_free = false;               ///< no start overlaps, as earlier answers say: they are not tested
};
/// How far a linkage may go along an edge.
struct EdgeAnswer {
  double fraction = 1;  ///< the edge is free on [0, fraction), as EarliestContact::toi_lower; 0 if the start overlaps
  double fraction_upper = 1;             ///< as EarliestContact::toi_upper
  bool overlaps_at_start = false;        ///< two bodies pass through each other at the start, or one is inside another
  std::array<BodyId, 2> bodies{-1, -1};  ///< which touch or overlap first; -1: the edge is free
  std::optional<BodyContact> contact;  ///< the contact that ends the edge; none if it is free, or overlaps at its start
  Point point{0, 0, 0};                ///< where the contact is, in the world's frame, in doubles

  /// Returns whether the edge is free, which is a proof.
  [[nodiscard]] bool is_free() const { return bodies[0] < 0; }
};
/// The first edge of a trajectory that is not free.
struct FirstBadEdge {
  std::optional<std::size_t> edge;  ///< its number: from waypoint `edge` to the next; none if all edges are free
  EdgeAnswer answer;                ///< about this edge
};
/// What is free of a roadmap. True is a proof.
struct FreeRoadmap {
  std::vector<bool> configurations;  ///< one entry a configuration
  std::vector<bool> edges;           ///< one entry an edge
};
/// How far all bodies may go.
struct BodyStep {
  double toi_lower = 1;              ///< as in SafeStep
  double toi_upper = 1;              ///< as in SafeStep
  std::optional<BodyNearPair> pair;  ///< the pair that ends the step; none if the whole step may go
};

/// Bodies, and the questions of a Detector about them. During t in [0,1] each body moves as it was told last. Pairs of
/// bodies that are far from each other cost next to nothing, whatever their meshes.
///
/// Items of other pairs that may touch are gathered and given to detectors, which the world keeps. Each deforming body
/// by itself has one. Pairs of bodies all of whose vertices go straight share one. Pairs with a body that turns share
/// one. So answers are proven as for a Step or a Path. One question or change at a time: a second one throws Busy. A
/// change that throws, also if memory is exhausted, has changed nothing. The answers do not depend on the number of
/// threads, on the instruction set, or on earlier questions.
class World {
 public:
  /// Makes a world without bodies. Of the options, `threads`, `min_separation`, `isa`, `is_cancelled` and the filter's
  /// `rings` count. Everything else is set by body.
  /// Throws InvalidOptions, also for an instruction set that this machine lacks.
  explicit World(Options options = {});
  ~World();
  /// A world that was moved from may be destroyed or assigned to. Every other call throws Error.
  World(World&&) noexcept;
  /// The same holds for the world that was assigned from.
  World& operator=(World&&) noexcept;

  /// Adds a body.
  /// Returns its number.
  /// Throws InvalidStep if a deforming body has not one point for each vertex of the shape at each end, if numbers are
  /// not finite, or if a body turns too far (Rigid).
  BodyId add(const Shape& shape, BodyMotion motion);
  /// Adds a body for each motion, or none of them.
  /// Returns their numbers.
  /// Throws as `add`.
  std::vector<BodyId> add_many(const Shape& shape, std::vector<BodyMotion> motions);
  /// Gives a body its motion from now on, of the same kind or another.
  /// Throws as `add`. All functions that name a body throw InvalidOptions if the world never had it, or no longer has
  /// it.
  void move(BodyId body, BodyMotion motion);
  /// Gives each of some bodies its motion, all or none.
  /// Throws as `move`. Throws InvalidOptions if a body is named twice, or if there are not as many motions.
  void move_many(std::span<const BodyId> bodies, std::vector<BodyMotion> motions);
  /// Returns the body's last motion; valid until the next change of the world.
  /// Throws InvalidOptions as `move`.
  [[nodiscard]] const BodyMotion& motion(BodyId body) const;
  /// Computes where a body's vertices are at `time` in [0,1] of its motion, on the curves that questions are about.
  /// Call it for a contact's time, to draw the body or to compute a response.
  /// Returns the points and their error. If the error is 0 these are the very points.
  /// Throws InvalidOptions on a time outside [0,1].
  [[nodiscard]] BodyPoints points_at(BodyId body, double time) const;
  /// Removes a body. Its number is not given again.
  /// Throws InvalidOptions as `move`.
  void remove(BodyId body);
  /// Switches a body off or on. A body that is switched off takes no part in any question. Bodies begin switched on.
  /// Throws InvalidOptions as `move`.
  void set_enabled(BodyId body, bool is_enabled);
  /// Sets half of a body's thickness, in the unit of the positions; 0 at first. Two bodies are in contact where their
  /// distance is at most the minimum separation plus both radii. A deforming body counts its radius twice against
  /// itself. Radii count in every question but `intersections`.
  /// Throws InvalidOptions if it is negative or not finite. A question throws InvalidOptions if the sum is more than
  /// any double.
  void set_radius(BodyId body, double radius);
  /// Sets whether two bodies, or a deforming body with itself (a == b), may touch. At first all may. Only a body that
  /// does not deform may not touch itself.
  /// Throws InvalidOptions to allow the latter.
  void set_may_touch(BodyId a, BodyId b, bool may_touch);
  /// Sets whether each of some pairs may touch, all or none.
  /// Throws as for one pair.
  void set_may_touch(std::span<const std::array<BodyId, 2>> pairs, bool may_touch);

  /// Finds all contacts. If one of two bodies turns, its contacts are answers about a Path (Detector). Some may be
  /// unresolved, and PathOptions::tolerance counts. AtStart::ignore skips a pair until the first of the times in
  /// docs/worlds.md at which it is proven apart.
  /// Returns the contacts sorted by kind, then bodies and vertices in the order of the features.
  /// Throws InvalidOptions, and with AtStart::fail InvalidStep.
  [[nodiscard]] std::vector<BodyContact> contacts(const PathOptions& = {});
  /// Finds the first contact of each pair of bodies, and of each deforming body with itself. Of all `contacts` of the
  /// pair this is the one with the least toi_lower. Of several such it is the first by kind, then bodies and vertices.
  /// Costs about as much as `earliest` where the same bodies meet, not as much as their contacts.
  /// Returns one contact for each pair that touches, sorted by its smaller body, then by its greater one.
  /// Throws as `contacts`.
  [[nodiscard]] std::vector<BodyContact> first_contacts(const PathOptions& = {});
  /// Finds the first contact.
  /// Returns a bracket of its time.
  /// Throws as `contacts`.
  [[nodiscard]] EarliestBodyContact earliest(const PathOptions& = {});
  /// Finds the first contact of each of many motions of some bodies, while all others move as they were told. Planners
  /// need this: they move from configuration to configuration. `motions`: for the first motion one entry for each of
  /// `bodies`, in their order, then for the second, and so on. Threads share the motions, each with a copy of the
  /// world's bodies. Afterwards the bodies have the motions of before.
  /// Returns an answer for each motion, with the bits that it has alone.
  /// Throws InvalidOptions if a body does not exist or is named twice, or if the number of motions is not a multiple of
  /// the number of bodies. Throws InvalidStep as `add`, naming the motion.
  [[nodiscard]] std::vector<EarliestBodyContact> earliest_many(std::span<const BodyId> bodies,
                                                               std::span<const BodyMotion> motions,
                                                               const PathOptions& = {});
  /// Tests whether the motion of all bodies is free of contacts.
  /// Returns true if that is proven.
  /// Throws as `contacts`.
  [[nodiscard]] bool is_free(const PathOptions& = {});

  /// Finds pairs of features within `distance` plus both radii where all bodies are at t=0, rounded to doubles. This
  /// question and the next three skip two bodies that are both Static, even where they pass through each other.
  /// PoseOptions::include_static includes them. Set it once, before the first step.
  /// Returns the pairs sorted as contacts.
  /// Throws InvalidOptions unless `distance` is finite and >= 0.
  [[nodiscard]] std::vector<BodyNearPair> pairs_within(double distance, const PoseOptions& = {});
  /// Finds edges that pass through triangles at t=0.
  /// Returns them sorted by bodies, edge and face.
  [[nodiscard]] std::vector<BodyIntersection> intersections(const PoseOptions& = {});
  /// Tests whether there is any intersection. Ends at the first one.
  /// Returns true if there is one.
  [[nodiscard]] bool has_intersection(const PoseOptions& = {});
  /// Tests whether two bodies overlap at t=0: there is an intersection, or a vertex of one lies inside another one. A
  /// body inside another touches nothing, so every motion within it is free. Use it on a planner's first
  /// configuration. Decided exactly for the positions that `intersections` sees. Only closed parts have an inside
  /// (`is_closed`). Where a body's parts lie in each other, their winding numbers add up: a part with reversed faces is
  /// a cavity (docs/worlds.md, "Inside").
  /// Returns true if there is an overlap.
  [[nodiscard]] bool has_overlap(const PoseOptions& = {});
  /// Tests whether a body's whole surface is closed: each edge has an even number of faces, if vertices at one place
  /// count as one. Open parts of other bodies contain nothing in `has_overlap`.
  /// Returns true if the body has a face and all its faces are in closed parts.
  /// Throws InvalidOptions as `move`.
  [[nodiscard]] bool is_closed(BodyId body) const;

  /// Finds how far all bodies may go, as Detector::safe_step. If one of two bodies turns, PathOptions::tolerance
  /// counts. A pair that starts nearer to its separation than doubles can tell ends the step at once.
  /// Returns a bracket of the time.
  /// Throws InvalidOptions unless 0 <= keep < 1, and as `contacts`.
  [[nodiscard]] BodyStep safe_step(double keep = 0.1, const PathOptions& = {});

  // Questions of planners, about a Linkage (tamis/linkage.hpp). Its bodies move along edges between configurations. All
  // other bodies take part in each edge with their own motions. Only pairs with a body of the linkage count. Threads
  // share the edges. Bodies keep the motions that they were told. All these functions throw InvalidOptions if
  // configurations have not `dimension` numbers each, if an option is out of its range, or if a body of the linkage
  // does not exist. They throw InvalidStep as `add`, naming the edge.

  /// Tests configurations. A configuration is free if nothing overlaps (`has_overlap`), and if no pair touches, or is
  /// within the minimum separation.
  /// Returns for each whether this is proven.
  [[nodiscard]] std::vector<bool> configurations_are_free(const Linkage&, std::span<const double> configurations,
                                                          const EdgeOptions& = {});
  /// Tests edges. An edge is free if its start does not overlap, and if it has no contact. Then none of its
  /// configurations overlaps.
  /// Returns for each whether this is proven.
  [[nodiscard]] std::vector<bool> edges_are_free(const Linkage&, std::span<const double> starts,
                                                 std::span<const double> ends, const EdgeOptions& = {});
  /// Finds how far each edge is free, with the contact that ends it.
  /// Returns an answer for each edge.
  [[nodiscard]] std::vector<EdgeAnswer> last_valid(const Linkage&, std::span<const double> starts,
                                                   std::span<const double> ends, const EdgeOptions& = {});
  /// Finds the first edge of a trajectory that is not free. `waypoints`: two configurations or more, one after the
  /// other. Only the first one is tested for an overlap: those that free edges reach have none. If other bodies move,
  /// all are tested, as obstacles begin each edge where they are at t = 0.
  [[nodiscard]] FirstBadEdge first_bad_edge(const Linkage&, std::span<const double> waypoints, const EdgeOptions& = {});
  /// Tests a roadmap. `edges`: the numbers of two configurations each. An edge is free if both its ends are, and if it
  /// has no contact.
  /// Returns what is free. Throws InvalidOptions also if an edge names a configuration that is not there.
  [[nodiscard]] FreeRoadmap roadmap(const Linkage&, std::span<const double> configurations,
                                    std::span<const std::array<Index, 2>> edges, const EdgeOptions& = {});

  /// Returns the cost of the last question: sums over the detectors that it used. `memory_bytes` does not count shapes.
  /// Throws Busy while a question is answered.
  [[nodiscard]] const Statistics& statistics() const;

 private:
  struct State;
  State& state() const;
  std::unique_ptr<State> state_;
};

}  // namespace tamis
