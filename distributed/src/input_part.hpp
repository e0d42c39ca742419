// A rank's part of the mesh as its caller gave it, and the facts about other ranks' parts that make it one mesh: which
// rank gives the position of a vertex, and which loose features belong to larger ones elsewhere.
#pragma once
#include <vector>

#include "distributed/src/communicator.hpp"
#include "distributed/src/partition/element_set.hpp"
#include "tamis/distributed.hpp"

namespace tamis::distributed {

/// Vertices whose positions go from one rank to another, in an order that both know.
struct SharedVertices {
  int rank;  ///< the other
  std::vector<std::size_t> places;
};

/// A vertex of the sample, and its place among those of this rank.
struct SampledPlace {
  std::size_t in_sample;
  Index place;
};

struct InputPart {
  /// The elements of this rank, and the vertices that it gives or uses. Without ids; without motions until
  /// take_positions.
  ElementSet elements;
  std::vector<Index> row_of_vertex;  ///< for each vertex its row of the positions; -1 if another rank gives it
  std::vector<bool> is_used;         ///< for each vertex: is it used by elements of this rank?
  std::vector<Index> spoken_for;     ///< places of the vertices whose home this rank is, and that any rank uses
  std::vector<SampledPlace> sample;  ///< those of them that are in the sample of which the frame is made
  std::vector<SharedVertices> lent;  ///< vertices whose home this rank is
  std::vector<SharedVertices> borrowed;
  Index row_count = 0;
  Index vertex_count = 0;      ///< of the whole mesh: the largest number plus 1
  std::size_t used_count = 0;  ///< of the vertices that any rank uses
};

/// Collective. Throws as the constructor of Detector does.
InputPart make_input_part(Communicator& communicator, const LocalMesh& mesh, const PairFilter& filter);

}  // namespace tamis::distributed
