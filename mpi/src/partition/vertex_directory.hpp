// Who knows which vertex: every rank keeps the book for a range of numbers, and tells those who ask. Asked once, when a
// detector is made.
#pragma once
#include <vector>

#include "mpi/src/communicator.hpp"
#include "mpi/src/sparse_exchange.hpp"
#include "tamis/mesh.hpp"

namespace tamis::distributed {

/// What a rank says of a vertex that it gives or uses.
struct Mention {
  Index number;
  Index group = 0;
  bool is_given = false;    ///< with a position, and its group
  bool is_covered = false;  ///< by a face or an edge
  bool is_on_loose_edge = false;
};

/// What it hears.
struct Entry {
  Index number;
  Index group;            ///< as its home has it
  int home;               ///< the lowest rank that gives its position; -1: none does
  bool is_covered;        ///< by a face or an edge of any rank
  bool is_on_loose_edge;  ///< of any rank
};

/// A vertex of this rank, its home, that another rank gives or uses as well.
struct Sharer {
  int rank;
  Index number;
};

struct DirectoryAnswer {
  std::vector<Entry> entries;   ///< of the vertices mentioned, by number
  std::vector<Sharer> sharers;  ///< by rank, then number
};

class VertexDirectory {
 public:
  VertexDirectory(Communicator& communicator, Index vertex_count);

  /// Collective. `mentions`: one a vertex.
  DirectoryAnswer look_up(const std::vector<Mention>& mentions);
  /// Collective. Of `loose`, those that are among the `sides` of triangles of any rank; sorted.
  std::vector<Edge> covered_edges(const std::vector<Edge>& loose, const std::vector<Edge>& sides);

 private:
  std::vector<Message> questions_of(const std::vector<Mention>& mentions) const;
  int rank_for(Index number) const { return static_cast<int>(number / range_); }

  Communicator& communicator_;
  const Index range_;  ///< of numbers, that one rank keeps
};

}  // namespace tamis::distributed
