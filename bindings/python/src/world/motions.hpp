// How some bodies move, from arrays: each stays at a pose, goes by a chain; or one deforms.
#pragma once
#include "python/src/paths/pose_rows.hpp"
#include "tamis/world.hpp"

namespace tamis::python {

struct AtPoses {
  PoseRows poses;
  std::size_t count() const { return poses.shape(0); }
  BodyMotion operator[](std::size_t i) const { return Static{row<Pose>(poses, i)}; }
};

struct ByChains {
  Chains chains;
  std::size_t count() const { return chains.shape(0); }
  BodyMotion operator[](std::size_t i) const { return Rigid{chain_at(chains, i)}; }
};

struct OneDeforming {
  PointRows start, end;
  std::size_t count() const { return 1; }
  BodyMotion operator[](std::size_t) const { return Deforming{copy_of<Point>(start), copy_of<Point>(end)}; }
};

}  // namespace tamis::python
