// A rank's part of the two frames of a step.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "mpi/src/communicator.hpp"
#include "tamis/distributed.hpp"

namespace tamis::distributed {

struct StepParts {
  LocalMesh mesh;
  std::vector<Point> start, end;
  std::uint64_t vertices = 0, triangles = 0;  ///< of the whole mesh

  /// Valid as long as this object.
  Step step() const { return {start, end}; }
};

/// Collective. Each rank gets a block of the vertices and one of each kind of features. Of binary PLY files of
/// triangles it reads no more than that; other files are read whole by every rank. Throws io::FileError, as Error, on
/// all ranks.
StepParts read_step_parts(Communicator& communicator, const std::string& start, const std::string& end, double scale);

}  // namespace tamis::distributed
