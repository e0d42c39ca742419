// Continuous collision detection of a mesh with itself, step after step.
#pragma once
#include <memory>
#include <vector>

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

/// Holds a mesh and the hierarchy over it: keep it from step to step. The first question builds the hierarchy; later
/// questions refit it, and rebuild it once refitting has made it poor. Pairs are of two features (PairKind) without a
/// common vertex. The answers do not depend on the number of threads, on the instruction set, or on earlier questions.
///
/// One question at a time: a second one, from another thread or from a function that the question calls (a filter, a
/// path), throws Busy at once. Such functions may ask other detectors, and use oneTBB.
///
/// The detector keeps the list of an answer until the next such question. A temporary detector, as in `for (const
/// Contact& c : Detector(mesh).contacts(step))`, hands the list to the caller.
class Detector {
 public:
  /// Throws InvalidOptions: threads < 0; a separation or radius that is negative or not finite; an instruction set that
  /// this machine lacks; groups or radii that do not fit the mesh or each other.
  explicit Detector(Mesh mesh, Options options = {});
  ~Detector();
  /// A detector that was moved from may be destroyed or assigned to; every other call throws Error. No thread may move,
  /// assign to or destroy a detector while it answers another thread.
  Detector(Detector&&) noexcept;
  Detector& operator=(Detector&&) noexcept;

  /// All contacts of the step, sorted by kind, then vertices. The vector is valid until the next question. QueryOptions
  /// hold what this question has of its own: throws InvalidOptions unless its separation is finite and >= 0, and if it
  /// has a tolerance (a path's). Every question throws InvalidStep unless start and end have one row of three numbers
  /// for each vertex of the mesh, finite for the vertices in mesh().points(); with AtStart::fail also if a pair touches
  /// at t=0.
  const std::vector<Contact>& contacts(const Step& step, const QueryOptions& = {}) &;
  std::vector<Contact> contacts(const Step& step, const QueryOptions& asked = {}) && { return contacts(step, asked); }
  /// Puts the same contacts into the caller's vector, without a copy: swaps its memory with the detector's.
  void contacts(const Step& step, std::vector<Contact>& result, const QueryOptions& = {});
  /// The first contact: how far the step may go (`truncate` returns the positions to go to). Its bracket may differ
  /// from that of contacts() in the last digits: both are proven.
  EarliestContact earliest(const Step& step, const QueryOptions& = {});
  /// Is the whole step free of contacts?
  bool is_free(const Step& step, const QueryOptions& = {});
  /// The same three questions about motion on curves, with the bounds that the path promises (tamis/path.hpp). The path
  /// is cut into pieces; each piece is asked about with straight chords. Pairs that chords do not prove free are
  /// decided on their curves, until they are proven free or their bracket is no wider than QueryOptions::tolerance.
  /// Times are the path's. Memory holds, of one piece at a time, all pairs that come nearer than their deviations.
  /// Throws InvalidPath if the path does not fit the mesh or breaks its promises, and InvalidOptions. With
  /// AtStart::ignore a pair that may touch at t=0 counts from the first of some times on at which it is proven apart
  /// (docs/numerics/curves.md, "Curved motion").
  const std::vector<Contact>& contacts(const Path& path, const QueryOptions& = {}) &;
  std::vector<Contact> contacts(const Path& path, const QueryOptions& asked = {}) && { return contacts(path, asked); }
  EarliestContact earliest(const Path& path, const QueryOptions& = {});
  bool is_free(const Path& path, const QueryOptions& = {});
  /// How far may the step go so that every pair keeps at least the fraction `keep` of its distance at t=0? The distance
  /// that counts is what exceeds the minimum separation and both radii. This is the step length for the line search of
  /// a barrier method. With 0 only contacts count, and `toi_lower` is earliest()'s toi_lower. Larger values take longer
  /// where motion is fast. Take 0.1 for a barrier's line search, whose next steps need space; 0.01 or less if a step
  /// should come near what it meets, as towards a first contact; 0.5 or more if distances may only shrink slowly. A
  /// pair that is ignored at the start (AtStart) has no distance to keep: it ends the step where it touches again.
  ///
  /// The proof is about the straight motion. Positions at a time up to `toi_lower` are rounded to doubles, and pairs
  /// that are a few units in the last place apart there may touch: ask `is_free` of the step to the rounded positions,
  /// or `truncate`, whose positions are proven as they are stored. Throws InvalidOptions unless 0 <= keep < 1.
  SafeStep safe_step(const Step& step, double keep = 0.1, const QueryOptions& = {});

  /// Every pair of features whose distance is at most `distance` plus both radii (Options::radii), each once, sorted by
  /// kind, then vertices: what a barrier or penalty method starts from. The list may hold some pairs that are farther
  /// apart, by less than the error of NearPair::distance. The vector is valid until the next such question. Throws
  /// InvalidOptions unless `distance` is finite and >= 0, InvalidStep unless the positions are as `contacts` requires.
  const std::vector<NearPair>& pairs_within(const Positions& positions, double distance) &;
  std::vector<NearPair> pairs_within(const Positions& at, double distance) && { return pairs_within(at, distance); }

  /// Every edge that passes through a triangle or touches it and shares no vertex with it, sorted by edge, then face:
  /// is this a pose to start from, and if not, why? Decided exactly. Radii do not count. Of the filter, groups (an edge
  /// has the group of its first vertex) and rings count; `accepts` does not. The vector is valid until the next such
  /// question. A mesh without faces has no intersections: for curves in the plane that cross each other ask
  /// `contacts({x, x})`, which lists every pair that touches at x.
  const std::vector<Intersection>& intersections(const Positions& positions) &;
  std::vector<Intersection> intersections(const Positions& positions) && { return intersections(positions); }
  /// Is there any intersection? Ends at the first one. For curves in the plane ask `is_free({x, x})`.
  bool has_intersection(const Positions& positions);

  /// Positions to go to, as doubles, so that every pair keeps `keep` of its distance, and one near pair does not stop
  /// the whole mesh. All vertices go together as long as every pair keeps a little more than `keep`. From there each
  /// vertex goes on by itself, on its own side of planes between the features that it could reach; by at most a quarter
  /// of the mean edge, which bounds the number of such pairs. (If the finest part of the mesh has edges less than a
  /// fourth as long, the mean edge of the vertex' own body counts.)
  ///
  /// A pair that starts within the minimum separation may move as long as it comes no nearer (at a distance of 0 not at
  /// all, not even apart); all other vertices then go that quarter at most. A pair that is ignored at the start
  /// (AtStart) may move freely, but not apart and back.
  ///
  /// A caller who keeps floats says so by `stored`: then all positions are values of floats, storing them as floats
  /// changes nothing, and the proof holds for what is stored. Throws InvalidOptions unless 0 < keep < 1; with floats
  /// InvalidStep unless `start` consists of values of floats and `end` is within their range.
  TruncatedStep truncate(const Step& step, double keep = 0.1, const QueryOptions& = {},
                         StoredType stored = StoredType::float64);

  const Mesh& mesh() const;
  const Options& options() const;
  /// The cost of the last question. Throws Busy while a question is answered.
  const Statistics& statistics() const;

 private:
  struct State;
  class LockedState;
  friend class DetectorAccess;  ///< makes detectors of other engines, within the library
  explicit Detector(std::unique_ptr<State> state);
  State& state() const;

  std::unique_ptr<State> state_;
};

}  // namespace tamis
