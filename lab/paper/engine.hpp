// The published pipeline.
#pragma once
#include "lab/detector.hpp"
#include "query/engine.hpp"

namespace tamis::lab {

/// Keeps references: mesh and options must outlive it, and `counts` where it is not null. REQUIRES (not checked): a
/// reduced model that fits the mesh where `paper` has one. Throws InvalidOptions: an unknown filter.
std::unique_ptr<Engine> make_paper_engine(const Mesh& mesh, const tamis::Options& options, const PaperOptions& paper,
                                          TriangleCounts* counts);

}  // namespace tamis::lab
