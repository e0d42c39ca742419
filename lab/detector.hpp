// A detector of any method: the library's validation, its order of answers, another engine.
#pragma once
#include "lab/options.hpp"
#include "tamis/detector.hpp"

namespace tamis::lab {

/// Of the paper's hierarchy, at the last question about a step.
struct TriangleCounts {
  std::uint64_t pairs = 0;            ///< of triangles that the hierarchy leaves
  std::uint64_t in_free_patches = 0;  ///< triangles, by high-level culling
};

/// Answers as every Detector does. Methods paper and brute measure stages by other names. `counts`, written by method
/// paper, must outlive the detector. Throws InvalidOptions: as Detector, and an unknown filter, a number that is none
/// of an enumeration's, subspace culling without a reduced model that fits the mesh.
Detector make_detector(Mesh mesh, const Options& options, TriangleCounts* counts = nullptr);

}  // namespace tamis::lab
