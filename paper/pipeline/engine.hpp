// The engine of Method::paper: the published pipeline.
#pragma once
#include "paper/detector.hpp"
#include "search/query/engine.hpp"

namespace tamis::lab {

/// Keeps references: mesh and options must outlive it, and `counts` if it is not null. REQUIRES (not checked): if
/// `paper` has a reduced model, it fits the mesh. Throws InvalidOptions for an unknown filter.
std::unique_ptr<Engine> make_paper_engine(const Mesh& mesh, const tamis::Options& options, const PaperOptions& paper,
                                          TriangleCounts* counts);

}  // namespace tamis::lab
