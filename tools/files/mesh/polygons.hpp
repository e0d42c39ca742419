// Cuts the polygons of a file into triangles, the same way for every format, and counts those that leave doubts.
#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "files/mesh/triangulation.hpp"

namespace tamis::io {

class Polygons {
 public:
  /// Appends the triangles of polygons: `counts` has the number of corners of each, `corners` all in turn. One with
  /// fewer than three corners has none. REQUIRES: as many corners as are counted, each the index of a position.
  void cut_all(std::span<const Index> counts, std::span<const Index> corners, std::span<const Point> positions,
               std::vector<Face>& faces);

  /// Had any polygon more than three corners?
  bool are_any_cut() const { return cut_ > 0; }

  /// Sentences on polygons that are bent or tangled.
  std::vector<std::string> doubts() const;
  /// Before these, how many were cut.
  std::vector<std::string> notes() const;

 private:
  void cut(std::span<const Index> corners, std::span<const Point> positions, std::vector<Face>& faces);

  /// Polygons of one sort.
  struct Count {
    std::size_t count = 0;
    std::string first;  ///< the vertices of the first one

    void add(std::span<const Index> corners);
    /// "3 polygons WHAT, the first joins vertices 1, 2, 3, 4".
    std::string text(const char* one, const char* many) const;
  };

  Triangulation triangulation_;
  std::size_t cut_ = 0;
  Count bent_, tangled_;
};

}  // namespace tamis::io
