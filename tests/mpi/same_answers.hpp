// Compares what many ranks say with what one process says.
#pragma once
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "mpi/parts.hpp"
#include "scenes/scene_list.hpp"
#include "tamis/detector.hpp"

namespace tamis::test {

Options one_thread();

void expect_same(const std::vector<Contact>& one, const std::vector<Contact>& many, const std::string& what);
void expect_same(const EarliestContact& one, const EarliestContact& many, const std::string& what);
void expect_same(const SafeStep& one, const SafeStep& many, const std::string& what);

/// Asks both everything about one step.
void expect_same_answers(Detector& one, distributed::Detector& many, const scenes::Scene& scene, const Part& part,
                         const std::string& what);

}  // namespace tamis::test
