// Cuts polygons into triangles, the same way for every format.
#pragma once
#include <fmt/format.h>

#include <cstddef>
#include <span>

#include "io/mesh/mesh_file.hpp"

namespace tamis::io {

class Polygons {
 public:
  /// Appends the fan around the first corner. REQUIRES: three corners or more.
  void add(std::span<const Index> corners, MeshFile& mesh) {
    for (std::size_t i = 2; i < corners.size(); ++i) mesh.faces.push_back({corners[0], corners[i - 1], corners[i]});
    if (corners.size() > 3) ++cut_;
  }

  /// Notes in the mesh how many polygons were cut, if any.
  void note(MeshFile& mesh) const {
    if (cut_ == 1) mesh.notes.emplace_back("1 polygon of more than three corners was cut into a fan of triangles");
    if (cut_ > 1)
      mesh.notes.push_back(fmt::format("{} polygons of more than three corners were cut into fans of triangles", cut_));
  }

 private:
  std::size_t cut_ = 0;
};

}  // namespace tamis::io
