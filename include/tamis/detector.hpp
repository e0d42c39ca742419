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
#include "tamis/stored.hpp"

namespace tamis {

/// Holds a mesh and the hierarchy over it. The first question builds the hierarchy; later ones refit it, and
/// rebuild it by themselves once refitting has made it poor. Pairs are of two features (PairKind) without
/// a common vertex. The answers do not depend on the number of threads, on the instruction set, or on earlier
/// questions. One question at a time: a second one meanwhile, of another thread or of a function that the question
/// calls (a filter, a path), throws Busy at once. Such functions may ask other detectors, and use oneTBB.
/// Lists stay in the detector until the next such question; of a detector that nobody keeps, as in
/// `for (const Contact& c : Detector(mesh).contacts(step))`, the caller gets them.
class Detector {
 public:
  /// Throws InvalidOptions: negative threads, a separation or radius that is negative or not finite, an instruction
  /// set this machine lacks, groups or radii that do not fit.
  explicit Detector(Mesh mesh, Options options = {});
  ~Detector();
  /// A detector that was moved from may be destroyed or assigned to; all else throws Error. Must not be moved, assigned
  /// to or destroyed by another thread while it answers.
  Detector(Detector&&) noexcept;
  Detector& operator=(Detector&&) noexcept;

  /// All contacts of the step, by kind, then vertices. The vector is valid until the next question. What a question may
  /// bring of its own is in QueryOptions: InvalidOptions unless its separation is finite and >= 0, and where it has a
  /// tolerance. Every question throws InvalidStep unless start and end have one row of three numbers for each vertex of
  /// the mesh, finite for those in mesh().points(); and with AtStart::fail if a pair touches at t=0.
  const std::vector<Contact>& contacts(const Step& step, const QueryOptions& = {}) &;
  std::vector<Contact> contacts(const Step& step, const QueryOptions& asked = {}) && { return contacts(step, asked); }
  /// The same contacts in the caller's own vector, not copied: its memory and the detector's change places.
  void contacts(const Step& step, std::vector<Contact>& result, const QueryOptions& = {});
  /// The first contact: how far the step may go; `truncate` says to which positions. Its bracket may differ from that
  /// of contacts() in the last digits: both are proven.
  EarliestContact earliest(const Step& step, const QueryOptions& = {});
  /// Is the whole step free of contacts?
  bool is_free(const Step& step, const QueryOptions& = {});
  /// The same three questions of curves, with the path's own certificates (tamis/path.hpp): pieces of the path are
  /// asked with straight chords, pairs that these leave are decided on their curves until they are proven free or their
  /// bracket is no wider than QueryOptions::tolerance. Times are the path's. All of a piece's
  /// pairs that come nearer than their deviations are held at a time. Throw InvalidPath where the path does not fit the
  /// mesh or breaks its promises, InvalidOptions. With AtStart::ignore a pair that may touch at t=0 counts from the
  /// first of some times on at which it is proven apart (docs/numerics.md, "Curved motion").
  const std::vector<Contact>& contacts(const Path& path, const QueryOptions& = {}) &;
  std::vector<Contact> contacts(const Path& path, const QueryOptions& asked = {}) && { return contacts(path, asked); }
  EarliestContact earliest(const Path& path, const QueryOptions& = {});
  bool is_free(const Path& path, const QueryOptions& = {});
  /// How far may the step go so that the distance of every pair, as far as it exceeds the minimum separation and both
  /// radii, stays at least `keep` of what it is at t=0? The step length for the line search of a barrier method. 0:
  /// only contacts count, and `lower` is earliest()'s toi_lower. Larger values take longer where motion is fast.
  /// Which: 0.1 for a barrier's line search, where the next steps need room; 0.01 and less where a step should come
  /// near what it meets, as towards a first contact; 0.5 and more where distances may shrink slowly only. A pair that
  /// is ignored at the start (AtStart) has nothing to keep: it ends the step where it touches again. What is proven is
  /// said of the straight motion: positions at a time up to `lower` are rounded to doubles, and pairs that are a few
  /// units in the last place apart there may touch. Ask `is_free` of the step to the rounded positions, or `truncate`,
  /// whose positions are proven as they are stored. Throws InvalidOptions unless 0 <= keep < 1.
  SafeStep safe_step(const Step& step, double keep = 0.1, const QueryOptions& = {});

  /// Every pair of features whose distance at rest is at most `distance` plus both radii (Options::radii), each
  /// once, by kind, then vertices: what a barrier or penalty method starts from. Some that are farther apart by less
  /// than NearPair::distance may be off can be among them. The vector is valid until the next such question. Throws
  /// InvalidOptions unless `distance` is finite and >= 0, InvalidStep as above.
  const std::vector<NearPair>& pairs_within(const Positions& positions, double distance) &;
  std::vector<NearPair> pairs_within(const Positions& at, double distance) && { return pairs_within(at, distance); }

  /// Every edge that passes through a triangle or touches it, without a common vertex, by edge, then face: is this a
  /// pose to start from, and if not, why? Decided exactly. Radii do not matter; of the filter groups (an edge has that
  /// of its first vertex) and rings count, `accepts` does not. The vector is valid until the next such question.
  /// Without faces there is nothing to find: of curves in the plane that cross each other ask `contacts({x, x})`, which
  /// lists every pair that touches at x.
  const std::vector<Intersection>& intersections(const Positions& positions) &;
  std::vector<Intersection> intersections(const Positions& positions) && { return intersections(positions); }
  /// Is there any? Ends at the first. Of curves in the plane ask `is_free({x, x})`, as above.
  bool has_intersection(const Positions& positions);

  /// Positions to go to, as doubles, so that every pair keeps `keep` of its distance, and one near pair does not
  /// stop all: all vertices go together as far as every pair keeps a little more than that, from there each on its own
  /// side of planes between the features that it could reach, by a quarter of the mean edge at most (of its body's,
  /// where the finest part has edges a fourth as long or shorter), so as to bound the number of such pairs. What starts
  /// within the minimum separation may move as long as it comes no nearer (at a distance of 0 not at all, not even
  /// apart), and all others go that quarter at most. What is ignored at the start (AtStart) may move as it likes, but
  /// not apart and back. A caller who keeps floats says so by `stored`: then all positions are floats' values, so that
  /// storing them changes nothing, and what is proven holds of what is stored. Throws InvalidOptions unless 0 < keep <
  /// 1, InvalidStep where floats are stored and `start` is not made of them, or `end` is beyond all of them.
  TruncatedStep truncate(const Step& step, double keep = 0.1, const QueryOptions& = {},
                         Stored stored = Stored::float64);

  const Mesh& mesh() const;
  const Options& options() const;
  /// Of the last question. Throws Busy during one.
  const Statistics& statistics() const;

 private:
  struct State;
  class LockedState;
  friend class DetectorAccess;  ///< within the library: of another engine
  explicit Detector(std::unique_ptr<State> state);
  State& state() const;

  std::unique_ptr<State> state_;
};

}  // namespace tamis
