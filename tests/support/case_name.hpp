// Names of tests that run for each family of pairs in each placement.
#pragma once
#include <gtest/gtest.h>

#include <string>
#include <tuple>

#include "support/pair_cases.hpp"
#include "support/test_names.hpp"

namespace tamis::test {

inline std::string case_name(const testing::TestParamInfo<std::tuple<std::size_t, std::size_t>>& parameter) {
  return test_name(kFamilies[std::get<0>(parameter.param)].name) + "_" +
         test_name(kPlacements[std::get<1>(parameter.param)].name);
}

}  // namespace tamis::test
