// The step of the questions, and other steps made from its start.
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

/// Reads two files, or makes a scene from its name and number of triangles. Throws the errors of reading.
Frames read_frames(const std::string& first, const std::string& second);

/// Turns all vertices of the start by 60 degrees about the z axis.
Frames turned_as_a_whole(const Frames& frames);
/// Two copies of the start's faces, side by side along x. Each turns by 60 degrees about the middle of its box, in
/// opposite senses. REQUIRES: the mesh has faces.
Frames turned_against_each_other(const Frames& frames);

}  // namespace tamis::bench
