// Every vertex its own step: all go together as far as every pair keeps a fraction of its distance; from there each
// vertex goes on, on its side of planes between the features that it could reach.
#pragma once
#include <vector>

#include "engines/rest_engine.hpp"
#include "tamis/mesh.hpp"

namespace tamis {

/// What of a step is asked, and until when it is proven that all may go together.
struct TogetherUntil {
  const Step& step;
  const Separations& separations;
  double time;  ///< as keep_distance says, for a fraction > 0
};

/// For each vertex of the mesh a time in [time, 1]: whatever times from `time` up to their own the vertices are at, no
/// pair comes into contact; proven. REQUIRES: a validated step; runs in the caller's oneTBB arena.
/// `near` is scratch.
std::vector<double> vertex_steps(const Mesh& mesh, RestEngine& engine, std::vector<NearPair>& near,
                                 const TogetherUntil& together, Statistics& statistics);

}  // namespace tamis
