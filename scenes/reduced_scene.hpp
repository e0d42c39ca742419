// A sheet bent into a U whose vertices move in a subspace: the example of ReducedModel.
#pragma once
#include <memory>

#include "scenes/scene.hpp"
#include "lab/reduced_model.hpp"

namespace tamis::scenes {

/// x = X + U q at both ends of the step.
struct ReducedScene {
  Scene scene;
  std::shared_ptr<const ReducedModel> model;
  std::vector<double> q_start, q_end;
};

/// About `triangles` triangles (at least a few); |q| = `length` at both ends, each in a random direction, so that the
/// arms of the U, `kReducedArmGap` apart, meet from about twice that on. The modes move no vertex by more than |q|.
ReducedScene reduced_sheet(Index triangles, std::uint64_t seed, double length);

inline constexpr double kReducedArmGap = 0.15;

}  // namespace tamis::scenes
