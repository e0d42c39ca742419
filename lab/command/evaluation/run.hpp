// Every method of the paper's laboratory over one sequence of frames, compared in every frame.
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

/// Sums over the steps of a sequence.
struct MethodResult {
  std::string method;
  double seconds = 0;  ///< of processor time; the first question, which builds the hierarchy, is asked beforehand
  std::vector<StageCount> stages;
  std::uint64_t contacts = 0;
  std::uint64_t missed = 0;  ///< reported by some other method in the same step, not by this one

  /// Pairs of features that enter the named stage; 0 if the method has no such stage.
  std::uint64_t entering(std::string_view stage) const;
  /// Pairs that the filters leave to the elementary test.
  std::uint64_t elementary_tests() const;
  /// Of these, the ones that are no contact.
  std::uint64_t false_pairs() const;
};

struct SceneResult {
  std::string scene;
  int factor;         ///< length of the step, in frames
  bool extrapolated;  ///< too few frames to leave some out: the step was stretched instead
  std::size_t triangles;
  std::size_t steps;      ///< that were run
  std::size_t all_steps;  ///< that the frames have
  std::vector<MethodResult> methods;
  /// The published filters, then others: of what NCF leaves, what each of those proves free.
  /// Stages only.
  MethodResult sieve;

  const MethodResult& method(std::string_view name) const;
  double milliseconds(std::string_view name) const;
  /// Every method reports every contact that any method reports.
  bool sets_agree() const;
};

/// What is compared, in the order of the tables: the default method first.
std::vector<std::string> paper_methods();

/// The filters of SceneResult::sieve, in their order.
std::vector<std::string> sieve_filters();

/// How the steps of a sequence are taken.
struct PaperSteps {
  int factor = 1;        ///< length of a step, in frames
  std::size_t most = 0;  ///< run at most so many, evenly spread; 0: all

  /// The frames at which the steps begin that a sequence of `frames` frames has.
  std::vector<std::size_t> begins(std::size_t frames) const;
};

/// One thread. `step_done` is called after each step.
SceneResult run_paper_scene(const SceneFrames& scene, const PaperSteps& steps, const std::function<void()>& step_done);

}  // namespace tamis::lab
