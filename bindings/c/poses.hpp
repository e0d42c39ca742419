// Converts points, poses and links from C.
#pragma once
#include <vector>

#include "c/sized.hpp"
#include "tamis/rigid_path.hpp"

namespace tamis::c {

/// Refuses NULL, unless the array has no elements.
template <class T>
const T* array(const T* first, std::size_t count, const char* name) {
  return count > 0 ? &required(first, name) : first;
}

inline Point point_of(const double* p) { return {p[0], p[1], p[2]}; }
inline Pose pose_of(const tamis_pose& pose) { return {point_of(pose.position), point_of(pose.rotation)}; }

inline std::vector<Point> point_rows(const double* coordinates, std::size_t count, const char* name) {
  const double* first = array(coordinates, count, name);
  std::vector<Point> result(count);
  for (std::size_t i = 0; i < count; ++i) result[i] = point_of(first + 3 * i);
  return result;
}

inline RigidChain chain_of(const tamis_rigid_link* links, std::size_t count) {
  RigidChain chain;
  chain.reserve(count);
  for (std::size_t i = 0; i < count; ++i) chain.push_back({pose_of(links[i].start), pose_of(links[i].end)});
  return chain;
}

}  // namespace tamis::c
