// What a detector keeps from question to question, and how each is answered.
#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "detect/arena.hpp"
#include "detect/contact_order.hpp"
#include "engines/engine.hpp"
#include "engines/rest_engine.hpp"
#include "engines/tamis/step_length.hpp"
#include "paths/path_search.hpp"
#include "tamis/detector.hpp"

namespace tamis {

struct Detector::State {
  State(Mesh m, Options o);

  /// Of a question; throws InvalidOptions.
  Separations separations(std::optional<double> min_separation) const;

  /// The contacts are in `found`.
  void ask(const Step& step, const Separations& separations, Question question);
  void ask(const Path& path, const Separations& separations, double tolerance, Question question);
  /// 0 < fraction < 1.
  SafeStep keep_distance(const Step& step, const Separations& separations, double fraction);
  VertexSteps vertex_steps(const Step& step, const Separations& separations, double fraction);
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

 private:
  RestEngine& at_rest();
  /// Runs `work` in the arena, with fresh statistics.
  template <class Work>
  void measure(const Work& work);
  std::uint64_t memory_bytes() const;

  Arena arena_;
  std::vector<double> radii_;  ///< of the vertices; empty: all zero
  std::unique_ptr<Engine> engine_;
  std::unique_ptr<StepLengthSearch> step_length_;  ///< made by the first question that needs it, as what follows
  std::unique_ptr<Engine> rest_engine_;            ///< where `engine_` does not answer at rest
  std::unique_ptr<PathSearch> path_search_;
  ContactSorter sorter_;
};

}  // namespace tamis
