// A rank's part of the mesh as its caller gave it, and what must be known of other ranks' parts to make it one mesh:
// who gives the position of a vertex, and which loose features belong to larger ones elsewhere.
#pragma once
#include <vector>

#include "mpi/src/communicator.hpp"
#include "mpi/src/partition/element_set.hpp"
#include "tamis/distributed.hpp"

namespace tamis::distributed {

/// Vertices whose positions go from one rank to another, in an order that both know.
struct SharedVertices {
  int rank;  ///< the other
  std::vector<std::size_t> places;
};

struct InputPart {
  /// Of this rank; vertices are those that it gives or uses. Neither ids nor motions.
  ElementSet elements;
  std::vector<Index> row_of_vertex;  ///< of the positions; -1: given elsewhere
  std::vector<bool> is_used;         ///< of each vertex, by elements here
  std::vector<SharedVertices> lent;  ///< this rank is their home
  std::vector<SharedVertices> borrowed;
  Index row_count = 0;
  Index vertex_count = 0;  ///< of the whole mesh: the largest number and 1
};

/// Collective. Throws as the constructor of Detector does.
InputPart make_input_part(Communicator& communicator, const LocalMesh& mesh, const PairFilter& filter);

}  // namespace tamis::distributed
