// A directory of which ranks have which vertices: every rank keeps it for a range of numbers, and answers the others.
// It is asked once, when a detector is made.
#pragma once
#include <vector>

#include "distributed/src/communicator.hpp"
#include "distributed/src/sparse_exchange.hpp"
#include "tamis/mesh.hpp"

namespace tamis::distributed {

/// What a rank tells the directory about a vertex that it gives or uses.
struct Mention {
  Index number;
  Index group = 0;
  bool is_given = false;    ///< this rank gives its position and group
  bool is_used = false;     ///< by a feature of this rank
  bool is_covered = false;  ///< by a face or an edge
  bool is_on_loose_edge = false;
};

/// What the directory answers about a vertex.
struct Entry {
  Index number;
  Index group;            ///< as its home gives it
  int home;               ///< the lowest rank that gives its position; -1: none does
  bool is_used;           ///< by a feature of any rank
  bool is_covered;        ///< by a face or an edge of any rank
  bool is_on_loose_edge;  ///< of any rank
};

/// A vertex whose home is this rank, and another rank that gives or uses it as well.
struct Sharer {
  int rank;
  Index number;
};

struct DirectoryAnswer {
  std::vector<Entry> entries;   ///< one for each vertex that was mentioned, by number
  std::vector<Sharer> sharers;  ///< by rank, then number
};

/// A vertex of the sample of which the frame is made (search/bounds/fine_place.hpp).
struct SampledNumber {
  std::size_t place;  ///< in the sample
  Index number;
};

/// The vertices that features of any rank use.
struct UsedVertices {
  std::size_t count = 0;
  std::vector<SampledNumber> sample;
};

class VertexDirectory {
 public:
  VertexDirectory(Communicator& communicator, Index vertex_count);

  /// Collective. `mentions`: one a vertex.
  DirectoryAnswer look_up(const std::vector<Mention>& mentions);
  /// Collective. REQUIRES: look_up.
  UsedVertices used_vertices() const;
  /// Collective. Returns those edges of `loose` that are among the `sides` of triangles of any rank; sorted.
  std::vector<Edge> covered_edges(const std::vector<Edge>& loose, const std::vector<Edge>& sides);

 private:
  std::vector<Message> questions_of(const std::vector<Mention>& mentions) const;
  int rank_for(Index number) const { return static_cast<int>(number / range_); }

  Communicator& communicator_;
  const Index range_;        ///< how many numbers one rank keeps
  std::vector<Index> used_;  ///< those of this rank's range that features use, ascending
};

}  // namespace tamis::distributed
