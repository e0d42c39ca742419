// The step that is asked about, and others made of its start.
#pragma once
#include <string>
#include <vector>

#include "tamis/mesh.hpp"
#include "tamis/step.hpp"

namespace tamis::bench {

struct Frames {
  Mesh mesh;
  std::vector<Point> start, end;

  Step step() const { return {start, end}; }
};

/// Two files, or the name of a scene and its number of triangles. Throws what reading throws.
Frames read_frames(const std::string& first, const std::string& second);

/// All of the start, by 60 degrees about the z axis.
Frames turned_as_a_whole(const Frames& frames);
/// The faces of the start twice, side by side along x, each turned by 60 degrees about the middle of its box, one to
/// and one fro. REQUIRES: there are some.
Frames turned_against_each_other(const Frames& frames);

}  // namespace tamis::bench
