// Step lengths by any method, and their comparison bit for bit.
#pragma once
#include <gtest/gtest.h>

#include <string>

#include "scenes/scene.hpp"
#include "support/yardstick/methods.hpp"
#include "tamis/detector.hpp"

namespace tamis::test {

inline SafeStep keep(const scenes::Scene& scene, double fraction, const yardstick::Options& options = {}) {
  return yardstick::make_detector(scene.mesh(), options).safe_step(scene.step(), fraction);
}

inline void expect_same(const SafeStep& a, const SafeStep& b, const std::string& where) {
  EXPECT_EQ(a.toi_lower, b.toi_lower) << where;
  EXPECT_EQ(a.toi_upper, b.toi_upper) << where;
  ASSERT_EQ(a.pair.has_value(), b.pair.has_value()) << where;
  if (!a.pair) return;
  EXPECT_EQ(a.pair->kind, b.pair->kind) << where;
  EXPECT_EQ(a.pair->vertices, b.pair->vertices) << where;
  EXPECT_EQ(a.pair->distance, b.pair->distance) << where;
}

}  // namespace tamis::test
