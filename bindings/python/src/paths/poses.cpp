// Poses and chains, as many as an array holds.
#include <string>

#include "python/src/arrays.hpp"
#include "python/src/bindings.hpp"
#include "python/src/paths/pose_rows.hpp"
#include "tamis/error.hpp"

namespace tamis::python {
namespace {

using Quaternions = nb::ndarray<const double, nb::shape<-1, 4>, nb::c_contig, nb::device::cpu>;
using Matrices = nb::ndarray<const double, nb::shape<-1, 3, 3>, nb::c_contig, nb::device::cpu>;

/// REQUIRES: as many rotations as positions, which the Python side sees to; so for all below.
template <class Rotation, class Rotations>
nb::object poses_of(const Rotations& rotations, const PointRows& positions,
                    Pose (*pose_of)(const Rotation&, const Point&)) {
  std::vector<Pose> poses(rotations.shape(0));
  for (std::size_t i = 0; i < poses.size(); ++i) {
    try {
      poses[i] = pose_of(row<Rotation>(rotations, i), row<Point>(positions, i));
    } catch (const InvalidPath& error) {
      throw InvalidPath("rotation " + std::to_string(i) + ": " + error.what());
    }
  }
  return own<double>(std::move(poses));
}

/// All links, one chain after the other.
template <class ChainAt>
nb::object chains_of(std::size_t count, const ChainAt& chain_at) {
  std::vector<RigidLink> links;
  for (std::size_t i = 0; i < count; ++i) {
    const RigidChain chain = chain_at(i);
    links.insert(links.end(), chain.begin(), chain.end());
  }
  return own<double>(std::move(links));
}

nb::object each_interpolated(const PoseRows& start, const PoseRows& end) {
  return chains_of(start.shape(0),
                   [&](std::size_t i) { return interpolated_chain(row<Pose>(start, i), row<Pose>(end, i)); });
}

nb::object each_turned(const PoseRows& start, const PointRows& turn, const PointRows& end, const PointRows& center) {
  return chains_of(start.shape(0), [&](std::size_t i) {
    return turned_chain(row<Pose>(start, i), row<Point>(turn, i), row<Point>(end, i), row<Point>(center, i));
  });
}

nb::object each_between(const PoseRows& start, const PoseRows& end, const PointRows& center) {
  return chains_of(start.shape(0), [&](std::size_t i) {
    return chain_between(row<Pose>(start, i), row<Pose>(end, i), row<Point>(center, i));
  });
}

nb::object each_pose_at(const Chains& chains, double time) {
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < chains.shape(0); ++i) poses.push_back(pose_at(chain_at(chains, i), time));
  return own<double>(std::move(poses));
}

nb::object each_nlerp_deviation(const PoseRows& start, const PoseRows& end) {
  std::vector<double> parts;
  for (std::size_t i = 0; i < start.shape(0); ++i)
    parts.push_back(nlerp_deviation(row<Pose>(start, i), row<Pose>(end, i)));
  return own<double>(std::move(parts));
}

}  // namespace

void bind_poses(nb::module_& module) {
  module.def("poses_of", [](const Quaternions& quaternions, const PointRows& positions) {
    return poses_of(quaternions, positions, &pose_of_quaternion);
  });
  module.def("poses_of", [](const Matrices& matrices, const PointRows& positions) {
    return poses_of(matrices, positions, &pose_of_matrix);
  });
  module.def("interpolated_chain", &each_interpolated);
  module.def("turned_chain", &each_turned);
  module.def("chain_between", &each_between);
  module.def("pose_at", &each_pose_at);
  module.def("nlerp_deviation", &each_nlerp_deviation);
}

}  // namespace tamis::python
