// Pairs at rest as a table.
#pragma once
#include <filesystem>
#include <span>

#include "tamis/proximity.hpp"

namespace tamis::io {

/// Columns kind,v0,v1,v2,v3,distance,u,v,dx,dy,dz, where d is the direction; kind is vf, ee, ve or vv, vertices
/// that a kind does not use are -1. Rows in the order of `pairs`; numbers read back to the same doubles. Atomically.
/// Throws FileError.
void write_near_csv(const std::filesystem::path& path, std::span<const NearPair> pairs);

/// Columns e0,e1,f0,f1,f2,s_lower,s_upper,u,v. Otherwise the same.
void write_intersections_csv(const std::filesystem::path& path, std::span<const Intersection> intersections);

}  // namespace tamis::io
