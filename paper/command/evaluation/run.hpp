// Runs all methods of the paper's evaluation over a sequence of frames and compares their contacts in each step.
#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "tamis/statistics.hpp"

namespace tamis::lab {

/// Frames of one mesh, in order.
struct SceneFrames {
  std::string name;
  std::vector<std::filesystem::path> frames;
};

/// One method's sums over the steps of a sequence.
struct MethodResult {
  std::string method;
  double seconds = 0;  ///< processor time; without the first question, which builds the hierarchy
  std::vector<StageCount> stages;
  std::uint64_t contacts = 0;
  std::uint64_t missed = 0;  ///< contacts that another method reports in the same step, and this one does not

  /// Pairs of features that enter the named stage; 0 if the method has no such stage.
  std::uint64_t entering(std::string_view stage) const;
  /// Pairs that the filters leave to the elementary test.
  std::uint64_t elementary_tests() const;
  /// Elementary tests that find no contact.
  std::uint64_t false_pairs() const;
};

struct SceneResult {
  std::string scene;
  int factor;         ///< length of the step, in frames
  bool extrapolated;  ///< the step was stretched, as there are too few frames for its length
  std::size_t triangles;
  std::size_t steps;      ///< steps that were run
  std::size_t all_steps;  ///< steps that the frames have
  std::vector<MethodResult> methods;
  /// Runs the published filters, then others: says which pairs of those that NCF leaves each of them proves free.
  /// Has stages only.
  MethodResult sieve;

  const MethodResult& method(std::string_view name) const;
  double milliseconds(std::string_view name) const;
  /// Every method reports every contact that any method reports.
  bool sets_agree() const;
};

/// Names of the methods that are compared, in the order of the tables: the default method first.
std::vector<std::string> paper_methods();

/// The filters of SceneResult::sieve, in their order.
std::vector<std::string> sieve_filters();

/// Which steps of a sequence are run.
struct PaperSteps {
  int factor = 1;        ///< length of a step, in frames
  std::size_t most = 0;  ///< run at most this many steps, evenly spread; 0: all

  /// The frames at which the steps begin, in a sequence of `frames` frames.
  std::vector<std::size_t> begins(std::size_t frames) const;
};

/// Runs all methods over a scene, on one thread. Calls `step_done` after each step.
SceneResult run_paper_scene(const SceneFrames& scene, const PaperSteps& steps, const std::function<void()>& step_done);

}  // namespace tamis::lab
