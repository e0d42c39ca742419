// What a detector keeps from question to question, and how each is answered.
#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "detect/arena.hpp"
#include "detect/contact_order.hpp"
#include "detect/planar_times.hpp"
#include "engines/engine.hpp"
#include "paths/path_search.hpp"
#include "tamis/detector.hpp"
#include "tamis/turn.hpp"

namespace tamis {

struct Detector::State {
  /// Of a question; none: the detector's.
  using Separation = std::optional<double>;

  State(Mesh m, Options o);

  /// The contacts are in `found`.
  void ask(const Step& step, Separation min_separation, Question question);
  void ask(const Path& path, Separation min_separation, double tolerance, Question question);
  EarliestContact earliest(const Step& step, Separation min_separation);
  SafeStep keep_distance(const Step& step, double fraction, Separation min_separation);
  TruncatedStep truncate(const Step& step, double fraction, Separation min_separation, Stored stored);
  /// The pairs are in `near`.
  void find_near(const Positions& positions, double distance);
  /// They are in `intersections`.
  void find_intersections(const Positions& positions, Intersections wanted);

  const Mesh mesh;
  const Options options;
  FoundContacts found{options};
  std::vector<NearPair> near;
  std::vector<Intersection> intersections;
  Statistics statistics;
  std::atomic_flag is_asked;  ///< the turn of the question that is being answered

 private:
  /// Of a validated step, whose end the caller can store.
  TruncatedStep truncate(const Step& step, const KeptFractions& fractions, const Separations& kept, Stored stored);
  /// Throws InvalidOptions.
  Separations separations(Separation min_separation) const;
  /// 0 < fraction < 1.
  SafeStep step_length(const Step& step, const Separations& separations, double fraction);
  /// Into the documented order.
  void sort_found();
  /// Runs `work` in the arena, with fresh statistics.
  template <class Work>
  void measure(const Work& work);
  std::uint64_t memory_bytes() const;

  Arena arena_;
  std::vector<double> radii_;  ///< of the vertices; empty: all zero
  std::unique_ptr<Engine> engine_;
  std::unique_ptr<PathSearch> path_search_;  ///< made by the first question that needs it
  ContactSorter sorter_;
};

/// What a question asks: the state, for as long as the question has its turn.
class Detector::Asked {
 public:
  /// Throws Busy, and Error of a detector that has been moved from.
  explicit Asked(const Detector& detector) : state_(detector.state()), turn_(state_.is_asked) {}
  State* operator->() const { return &state_; }

 private:
  State& state_;
  const Turn turn_;
};

}  // namespace tamis
