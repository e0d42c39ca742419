// The state that a detector keeps from question to question, and the functions that answer questions.
#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "api/contact_order.hpp"
#include "api/detector_access.hpp"
#include "numbers/busy_guard.hpp"
#include "numbers/floating_point_state.hpp"
#include "numbers/parallel.hpp"
#include "search/bounds/box_frame.hpp"
#include "search/query/engine.hpp"
#include "search/query/stopwatch.hpp"
#include "search/topology/rings.hpp"
#include "tamis/detector.hpp"

namespace tamis {

struct Detector::State {
  State(Mesh m, Options o, const MakeEngine& make_engine);
  /// Sets each vertex's radius, before the first question. REQUIRES: a radius for each vertex, no radii in the options.
  /// REQUIRES (not checked: O(n)): finite and >= 0.
  void set_radii(std::vector<double> radii);

  /// As in DetectorAccess.
  void use_frame(const BoxFrame& of_scene) { frame_ = of_scene; }

  // Three questions about a Step or a CutPath.

  /// All contacts: those in `found`.
  const std::vector<Contact>& find_contacts(const auto& motion, const auto& asked) {
    find(motion, asked, Question::all_contacts);
    return found.contacts();
  }
  EarliestContact earliest(const auto& motion, const auto& asked) { return find(motion, asked, Question::earliest); }
  /// The first contact of each of these pairs of bodies that has one: the contacts in `found`. For a world's mesh.
  const std::vector<Contact>& first_contacts(const auto& motion, const auto& asked, const BodyPairs& each_of) {
    find(motion, asked, Question::earliest, &each_of);
    return found.contacts();
  }
  /// AtStart::fail needs the earliest contact. Any other does not tell whether a pair touches at the start.
  bool is_free(const auto& motion, const auto& asked) {
    if (asked.at_start == AtStart::fail) return !earliest(motion, asked).contact;
    find(motion, asked, Question::is_free);
    return found.contacts().empty();
  }

  SafeStep safe_step(const Step& step, double keep, const QueryOptions& asked);
  /// On a path, a pair that starts nearer to its separation than doubles can tell ends the step at t=0.
  SafeStep safe_step(const CutPath& path, double keep, const PathOptions& asked);
  TruncatedStep truncate(const Step& step, double keep, const QueryOptions& asked, StoredType stored);
  const std::vector<NearPair>& find_near(const Positions& positions, double distance);
  /// All intersections, or for `is_free` some, if there are any. `by_accepts`: only those that `accepts` of the
  /// options' filter accepts. It is called with a vertex of the edge, and the face.
  const std::vector<Intersection>& find_intersections(const Positions& positions, Question question,
                                                      bool by_accepts = false);

  const Mesh mesh;
  const Options options;
  ContactCollector found;
  Statistics statistics;
  std::atomic_flag is_asked;  ///< set while a question has its turn

 private:
  /// Throws InvalidOptions.
  Separations separations(double fixed) const;
  /// The query about a validated step.
  Query query(const Step& step, const Separations& separations, Question question = Question::all_contacts) const {
    return {step, separations, options.filter, rings_, options.is_cancelled, question};
  }
  /// The same with a question's own options. Throws InvalidOptions.
  Query asked_query(const Step& step, const QueryOptions& asked, Question question, const BodyPairs* each_of) const;
  template <class Find>
  void on_path(const CutPath& path, double keep, const PathOptions& asked, Question question, const BodyPairs* each_of,
               const Find& find);
  /// Truncates the step of a validated query. The caller can store the positions at its end.
  TruncatedStep truncate(const Query& whole, double keep, AtStart at_start, StoredType stored);
  /// Runs a loop over the vertices, in the arena if it is long enough for threads to share.
  template <class Work>
  void in_arena_if_long(const Work& work);
  /// Throws InvalidOptions, InvalidStep.
  Query validated_query(const Step& step, const QueryOptions& asked, Question question = Question::all_contacts,
                        const BodyPairs* each_of = nullptr);
  /// Finds contacts, which `found` holds then. For `earliest` it holds the first, which is returned, or with `each_of`
  /// the first contacts of the pairs of bodies. Throws InvalidOptions, InvalidStep, InvalidPath.
  EarliestContact find(const Step& step, const QueryOptions& asked, Question question,
                       const BodyPairs* each_of = nullptr);
  EarliestContact find(const CutPath& path, const PathOptions& asked, Question question,
                       const BodyPairs* each_of = nullptr);
  EarliestContact find(const Query& query);
  /// Throws InvalidStep, which names the pair: it touches at the step's start.
  [[noreturn]] void refuse_start(const Query& query, const Contact& touching) const;
  /// 0 < keep < 1.
  SafeStep step_length(const Query& query, double keep, AtStart at_start);
  /// Sorts `found` into the documented order.
  void sort_found();
  /// Runs `work` in the arena, with fresh statistics.
  template <class Work>
  void measure(const Work& work);
  /// The same for another part of the question measured last: adds to its statistics.
  template <class Work>
  void measure_more(const Work& work);
  std::uint64_t memory_bytes() const;

  Rings rings_;
  Arena arena_;
  Bound bound_;  ///< of the contacts in `found`
  std::vector<NearPair> near_;
  std::vector<Intersection> intersections_;
  std::vector<double> radii_;      ///< of the vertices; empty: all zero
  std::optional<BoxFrame> frame_;  ///< of the whole scene, if the mesh is a part of it
  std::unique_ptr<Engine> engine_;
  ContactSorter sorter_;
};

template <class Work>
void Detector::State::measure(const Work& work) {
  statistics = {};
  measure_more(work);
}

template <class Work>
void Detector::State::measure_more(const Work& work) {
  const Stopwatch watch;
  arena_.run([&] {
    statistics.threads = threads_here();
    work();
  });
  statistics.memory_bytes = memory_bytes();
  statistics.seconds.total += watch.seconds();
}

/// The state, for as long as one question has its turn.
class Detector::LockedState {
 public:
  /// Throws Busy, and Error of a detector that has been moved from.
  explicit LockedState(const Detector& detector) : state_(detector.state()), guard_(state_.is_asked) {}
  State* operator->() const { return &state_; }

 private:
  State& state_;
  const BusyGuard guard_;
  const ComputingState computing_;
};

}  // namespace tamis
