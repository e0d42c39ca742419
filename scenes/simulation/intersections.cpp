#include "scenes/simulation/intersections.hpp"

#include <algorithm>
#include <numeric>

namespace tamis::simulation {

std::vector<Contact> find_intersections(const Mesh& mesh, Positions positions, const PairFilter& pairs) {
  const Index vertices = mesh.vertex_count();
  std::vector<Point> start, end;
  for (Index v = 0; v < vertices; ++v) start.push_back({positions[v][0], positions[v][1], positions[v][2]});
  end = start;
  Options options;
  options.guarantee = Guarantee::exact;
  options.filter = pairs;
  std::vector<Index>& group = options.filter.group_of_vertex;
  for (const auto& [a, b] : mesh.edges()) {
    start.push_back(start[static_cast<std::size_t>(a)]);
    end.push_back(end[static_cast<std::size_t>(b)]);
    if (!group.empty()) group.push_back(group[static_cast<std::size_t>(a)]);
  }
  // Runner r goes along edge r - vertices; it meets the faces around its edge's ends there, which is no intersection.
  options.filter.accepts = [&mesh, vertices](PairKind, const std::array<Index, 4>& v) {
    if (v[0] < vertices) return true;
    const Edge& edge = mesh.edges()[static_cast<std::size_t>(v[0] - vertices)];
    return std::none_of(v.begin() + 1, v.end(), [&](Index corner) { return corner == edge[0] || corner == edge[1]; });
  };
  std::vector<Index> runners(mesh.edges().size());
  std::iota(runners.begin(), runners.end(), vertices);
  const std::vector<Face> faces(mesh.faces().begin(), mesh.faces().end());
  Detector detector(Mesh(static_cast<Index>(start.size()), faces, {}, runners), options);
  return detector.contacts({start, end});
}

}  // namespace tamis::simulation
