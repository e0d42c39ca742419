// A detector of any method: with the library's validation and order of answers, and the method's engine.
#pragma once
#include "paper/options.hpp"
#include "tamis/detector.hpp"

namespace tamis::lab {

/// Counts in the paper's hierarchy, from the last question about a step.
struct TriangleCounts {
  std::uint64_t pairs = 0;            ///< pairs of triangles that the hierarchy leaves
  std::uint64_t in_free_patches = 0;  ///< triangles in patches that high-level culling proves free
};

/// Answers as every Detector does. Methods paper and brute measure stages by other names. `counts`, written by method
/// paper, must outlive the detector. Throws InvalidOptions as Detector does, and also for an unknown filter, a number
/// that no enumerator has, and subspace culling without a reduced model that fits the mesh.
Detector make_detector(Mesh mesh, const Options& options, TriangleCounts* counts = nullptr);

}  // namespace tamis::lab
