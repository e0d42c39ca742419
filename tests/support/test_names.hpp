// Names of test parameters: GoogleTest allows letters, digits and underscores.
#pragma once
#include <gtest/gtest.h>

#include <cctype>
#include <ostream>
#include <string>
#include <string_view>

#include "scenes/scene_list.hpp"

namespace tamis::test {

inline std::string test_name(std::string_view text) {
  std::string name(text);
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  return name;
}

inline std::string scene_test_name(const testing::TestParamInfo<scenes::Recipe>& parameter) {
  return test_name(parameter.param.name);
}

}  // namespace tamis::test

namespace tamis::scenes {
/// GoogleTest calls this to print the parameter of a failed test.
inline void PrintTo(const Recipe& recipe, std::ostream* out) { *out << recipe.name; }
}  // namespace tamis::scenes
