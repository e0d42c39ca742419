// Compares what many ranks say with what one process says.
#pragma once
#include <gtest/gtest.h>

#include <span>
#include <string>
#include <vector>

#include "distributed/tests/parts.hpp"
#include "scenes/scene_list.hpp"
#include "tamis/detector.hpp"

namespace tamis::test {

Options one_thread();

void expect_same(std::span<const Contact> one, std::span<const Contact> many, const std::string& what);
void expect_same(const EarliestContact& one, const EarliestContact& many, const std::string& what);
void expect_same(const SafeStep& one, const SafeStep& many, const std::string& what);

/// What one process says of a step.
struct OneAnswers {
  double separation;  ///< of those that ignore what touches at the start
  std::vector<Contact> contacts;
  EarliestContact earliest, earliest_ignoring_start;
  bool is_free;
  std::vector<SafeStep> safe;
  SafeStep safe_ignoring_start;

  QueryOptions ignoring_start() const { return {.min_separation = separation, .at_start = AtStart::ignore}; }
};
/// `separation`: in the unit of the scene; some pairs of generated ones start within this.
OneAnswers answers_of(Detector& one, const scenes::Scene& scene, double separation = 0x1p-6);

/// Asks everything about the step of which one process has said `one`.
void expect_same_answers(const OneAnswers& one, distributed::Detector& many, const Part& part, const std::string& what);

/// Asks everything about the scene's step, in all ways to cut it in parts.
void expect_same_for_all_cuts(const scenes::Scene& scene, const Options& options = one_thread());

}  // namespace tamis::test
