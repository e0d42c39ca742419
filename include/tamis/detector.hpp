// Continuous collision detection of a mesh with itself, step after step.
#pragma once
#include <memory>
#include <span>

#include "tamis/contact.hpp"
#include "tamis/mesh.hpp"
#include "tamis/options.hpp"
#include "tamis/path.hpp"
#include "tamis/proximity.hpp"
#include "tamis/statistics.hpp"
#include "tamis/step.hpp"
#include "tamis/step_length.hpp"
#include "tamis/stored_type.hpp"

namespace tamis {

/// Holds a mesh and the hierarchy over it: keep it from step to step. The first question builds the hierarchy. Later
/// questions refit it, and rebuild it once refitting has made it poor. Pairs are of two features (PairKind) without a
/// common vertex. The answers do not depend on the number of threads, on the instruction set, or on earlier questions.
///
/// One question at a time: a second one throws Busy at once. It may come from another thread, or from a function that
/// the question calls (a filter, a path). Such functions may query other detectors, and use oneTBB.
///
/// Questions that return a list return a view of the detector's memory. It is valid until the next question.
///
/// Every question about a step or positions throws InvalidStep unless these have one row of three numbers for each
/// vertex of the mesh. The rows of the vertices in mesh().points() must be finite. With AtStart::fail it throws
/// InvalidStep also if a pair touches at t=0. Every question throws InvalidOptions unless its minimum separation is
/// finite and >= 0.
class Detector {
 public:
  /// Takes a mesh, and options for all questions.
  /// Throws InvalidOptions: threads < 0; a separation or radius that is negative or not finite; an instruction set that
  /// this machine lacks; groups or radii that do not fit the mesh or each other.
  explicit Detector(Mesh mesh, Options options = {});
  ~Detector();
  /// A detector that was moved from may be destroyed or assigned to. Every other call throws Error. No thread may move,
  /// assign to or destroy a detector while it answers another thread.
  Detector(Detector&&) noexcept;
  /// The same holds for the detector that was assigned from.
  Detector& operator=(Detector&&) noexcept;

  /// Finds all contacts of the step.
  /// Returns them sorted by kind, then vertices.
  /// Throws InvalidStep and InvalidOptions as every question.
  [[nodiscard]] std::span<const Contact> contacts(const Step& step, const QueryOptions& = {}) &;
  /// Finds the first contact: how far the step may go. (`truncate` returns positions to go to.)
  /// Returns it with the bits that contacts() has for it. Where 64 pairs or more touch at one time, toi_lower may be a
  /// little earlier.
  /// Throws as `contacts`.
  [[nodiscard]] EarliestContact earliest(const Step& step, const QueryOptions& = {});
  /// Tests whether the whole step is free of contacts. Ends at the first contact that it finds.
  /// Returns true if that is proven.
  /// Throws as `contacts`.
  [[nodiscard]] bool is_free(const Step& step, const QueryOptions& = {});

  /// Finds all contacts of a motion on curves, with the bounds that the path promises (tamis/path.hpp). The path is cut
  /// into pieces; each piece becomes a query about straight chords. Pairs that chords do not prove free are decided on
  /// their curves. This ends when each is proven free or has a bracket no wider than PathOptions::tolerance. Memory
  /// holds, of one piece at a time, all pairs that come nearer than their deviations. With AtStart::ignore a pair that
  /// may touch at t=0 counts from the first of some times on at which it is proven apart (docs/numerics/curves.md,
  /// "Curved motion").
  /// Returns the contacts sorted by kind, then vertices. Times are the path's.
  /// Throws InvalidPath if the path does not fit the mesh or breaks its promises. Throws InvalidOptions unless the
  /// tolerance is in (0, 1]. With AtStart::fail throws InvalidStep if a pair may touch at t=0.
  [[nodiscard]] std::span<const Contact> contacts(const Path& path, const PathOptions& = {}) &;
  /// Finds the first contact on the path.
  /// Returns a bracket of its time.
  /// Throws as `contacts` of a path.
  [[nodiscard]] EarliestContact earliest(const Path& path, const PathOptions& = {});
  /// Tests whether the whole path is free of contacts.
  /// Returns true if that is proven.
  /// Throws as `contacts` of a path.
  [[nodiscard]] bool is_free(const Path& path, const PathOptions& = {});

  /// Finds how far the step may go while every pair keeps at least the fraction `keep` of its distance at t=0. The
  /// distance that counts is the distance beyond the minimum separation and both radii. This is the step length for the
  /// line search of a barrier method. Larger values take longer where motion is fast. Take 0.1 for a barrier's line
  /// search, whose next steps need space. Take 0.01 or less if a step should come near obstacles, as towards a first
  /// contact. Take 0.5 or more if distances may only shrink slowly. A pair that is ignored at the start (AtStart) has
  /// no distance to keep. It ends the step where it touches again.
  ///
  /// The proof is about the straight motion. Positions at a time up to `toi_lower` are rounded to doubles. Pairs that
  /// are a few units in the last place apart there may touch. Query `is_free` about the step to the rounded positions,
  /// or use `truncate`. The positions of `truncate` are proven as they are stored.
  /// Returns a bracket of the time. With keep = 0 only contacts count, and `toi_lower` is the same as earliest()
  /// returns.
  /// Throws InvalidOptions unless 0 <= keep < 1, and as `contacts`.
  [[nodiscard]] SafeStep safe_step(const Step& step, double keep = 0.1, const QueryOptions& = {});

  /// Finds every pair of features whose distance is at most `distance` plus both radii (Options::radii). Barrier and
  /// penalty methods start from this list. The list may hold some pairs that are farther apart, by less than the error
  /// of NearPair::distance.
  /// Returns each pair once, sorted by kind, then vertices.
  /// Throws InvalidOptions unless `distance` is finite and >= 0, InvalidStep as every question.
  [[nodiscard]] std::span<const NearPair> pairs_within(const Positions& positions, double distance) &;

  /// Finds every edge that passes through a triangle or touches it and shares no vertex with it. A pose without
  /// intersections is a pose to start from. Decided exactly. Radii do not count. Of the filter, groups (an edge has the
  /// group of its first vertex) and rings count; `accepts` does not. A mesh without faces has no intersections. For
  /// curves in the plane that cross each other use `contacts({x, x})`, which lists every pair that touches at x.
  /// Returns the intersections sorted by edge, then face.
  /// Throws InvalidStep as every question.
  [[nodiscard]] std::span<const Intersection> intersections(const Positions& positions) &;
  /// Tests whether there is any intersection. Ends at the first one. For curves in the plane use `is_free({x, x})`.
  /// Returns true if there is one.
  /// Throws InvalidStep as every question.
  [[nodiscard]] bool has_intersection(const Positions& positions);

  /// Finds positions to go to, as doubles. Every pair keeps `keep` of its distance, and one near pair does not stop the
  /// whole mesh. All vertices go together as long as every pair keeps a little more than `keep`. From there each vertex
  /// moves by itself. It stays on its own side of planes between the features that it could reach. It moves by at most
  /// a quarter of the mean edge. This bounds the number of such pairs. (If the finest part of the mesh has edges less
  /// than a fourth as long, the mean edge of the vertex' own body counts.)
  ///
  /// A pair that starts within the minimum separation may move as long as it comes no nearer (at a distance of 0 not at
  /// all, not even apart). All other vertices then go that quarter at most. A pair that is ignored at the start
  /// (AtStart) may move freely, but not apart and back.
  ///
  /// A caller who keeps floats sets `stored`. Then all positions are float values. Storing them as floats changes
  /// nothing, and the proof holds for the stored positions.
  /// Returns a position and a fraction for each vertex.
  /// Throws InvalidOptions unless 0 < keep < 1. With floats it throws InvalidStep unless `start` consists of values of
  /// floats and `end` is within their range. Also throws as `contacts`.
  [[nodiscard]] TruncatedStep truncate(const Step& step, double keep = 0.1, const QueryOptions& = {},
                                       StoredType stored = StoredType::float64);

  // A list of a temporary detector would be gone when the question returns. Keep the detector in a variable.
  void contacts(const Step&, const QueryOptions& = {}) && = delete;
  void contacts(const Path&, const PathOptions& = {}) && = delete;
  void pairs_within(const Positions&, double) && = delete;
  void intersections(const Positions&) && = delete;

  /// Returns the mesh.
  [[nodiscard]] const Mesh& mesh() const;
  /// Returns the options for all questions.
  [[nodiscard]] const Options& options() const;
  /// Returns the cost of the last question.
  /// Throws Busy while a question is answered.
  [[nodiscard]] const Statistics& statistics() const;

 private:
  struct State;
  class LockedState;
  friend class DetectorAccess;  ///< makes detectors of other engines, within the library
  explicit Detector(std::unique_ptr<State> state);
  State& state() const;

  std::unique_ptr<State> state_;
};

}  // namespace tamis
