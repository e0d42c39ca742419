// A rank's part of the two frames of a step.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "distributed/src/communicator.hpp"
#include "tamis/distributed.hpp"

namespace tamis::distributed {

struct StepParts {
  LocalMesh mesh;
  std::vector<Point> start, end;
  std::uint64_t vertices = 0, triangles = 0;  ///< of the whole mesh

  /// Valid as long as this object.
  Step step() const { return {start, end}; }
};

/// Collective. Each rank gets a block of the vertices and a block of each kind of features. Binary PLY files of
/// triangles are read by blocks; every rank reads all other files whole. Throws io::FileError, as Error, on all ranks.
StepParts read_step_parts(Communicator& communicator, const std::string& start, const std::string& end, double scale);

}  // namespace tamis::distributed
