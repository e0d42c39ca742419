// A scene cut in parts, one a rank, in ways that are kind and unkind.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "scenes/scene.hpp"
#include "tamis/distributed.hpp"

namespace tamis::test {

inline int rank_of(MPI_Comm communicator = MPI_COMM_WORLD) {
  int rank = 0;
  MPI_Comm_rank(communicator, &rank);
  return rank;
}

inline int rank_count(MPI_Comm communicator = MPI_COMM_WORLD) {
  int count = 0;
  MPI_Comm_size(communicator, &count);
  return count;
}

/// What one rank has, and the rows of positions that belong to it.
struct Part {
  distributed::LocalMesh mesh;
  std::vector<Index> group_of_vertex;
  std::vector<Point> start, end;

  Step step() const { return {start, end}; }
  /// The rows of other positions of the whole scene.
  void move(const std::vector<Point>& all_start, const std::vector<Point>& all_end);
};

/// Who has what: the rank of element i of `count`, in the order faces, loose edges, loose points; and who gives the
/// positions.
struct Cut {
  std::string name;
  std::function<int(const scenes::Scene&, std::size_t i, std::size_t count)> rank_of_element;
  bool gives_every_vertex_once = false;  ///< to the rank of its number, whoever uses it; else all users give it
};

/// Blocks, round robin, everything on the last rank, even ranks alone, one rank an object.
const std::vector<Cut>& cuts();

Part part_of(const scenes::Scene& scene, const Cut& cut);

}  // namespace tamis::test
