#include "distributed/tests/parts.hpp"

#include <set>

namespace tamis::test {
namespace {

using scenes::Scene;

int block_of(std::size_t i, std::size_t count) {
  return static_cast<int>(i * static_cast<std::size_t>(rank_count()) / count);
}

int turn_of(std::size_t i) { return static_cast<int>(i % static_cast<std::size_t>(rank_count())); }

/// The object of the element's first vertex.
int object_of(const Scene& scene, std::size_t i) {
  const std::size_t faces = scene.faces.size(), edges = scene.loose_edges.size();
  const Index vertex = i < faces           ? scene.faces[i][0]
                       : i < faces + edges ? scene.loose_edges[i - faces][0]
                                           : scene.loose_points[i - faces - edges];
  return scene.group_of_vertex[static_cast<std::size_t>(vertex)];
}

std::vector<Cut> make_cuts() {
  return {{"blocks", [](const Scene&, std::size_t i, std::size_t count) { return block_of(i, count); }},
          {"round robin", [](const Scene&, std::size_t i, std::size_t) { return turn_of(i); }},
          {"round robin, vertices too", [](const Scene&, std::size_t i, std::size_t) { return turn_of(i); }, true},
          {"all on the last", [](const Scene&, std::size_t, std::size_t) { return rank_count() - 1; }},
          {"odd ranks empty", [](const Scene&, std::size_t i, std::size_t) { return turn_of(i) / 2 * 2; }},
          {"one rank an object",
           [](const Scene& scene, std::size_t i, std::size_t) { return object_of(scene, i) % rank_count(); }}};
}

}  // namespace

const std::vector<Cut>& cuts() {
  static const std::vector<Cut> all = make_cuts();
  return all;
}

void Part::move(const std::vector<Point>& all_start, const std::vector<Point>& all_end) {
  start.clear();
  end.clear();
  for (const Index v : mesh.vertices) {
    start.push_back(all_start[static_cast<std::size_t>(v)]);
    end.push_back(all_end[static_cast<std::size_t>(v)]);
  }
}

Part part_of(const Scene& scene, const Cut& cut) {
  Part part;
  std::set<Index> given;
  std::size_t i = 0;
  const std::size_t count = scene.faces.size() + scene.loose_edges.size() + scene.loose_points.size();
  const auto is_mine = [&] { return cut.rank_of_element(scene, i++, count) == rank_of(); };
  for (const Face& face : scene.faces)
    if (is_mine()) part.mesh.faces.push_back(face), given.insert(face.begin(), face.end());
  for (const Edge& edge : scene.loose_edges)
    if (is_mine()) part.mesh.loose_edges.push_back(edge), given.insert(edge.begin(), edge.end());
  for (const Index point : scene.loose_points)
    if (is_mine()) part.mesh.loose_points.push_back(point), given.insert(point);
  if (cut.gives_every_vertex_once) {
    given.clear();
    for (Index v = rank_of(); v < scene.vertex_count(); v += rank_count()) given.insert(v);
  }
  // Not in the order of their numbers: rows are the caller's.
  part.mesh.vertices.assign(given.rbegin(), given.rend());
  for (const Index v : part.mesh.vertices)
    part.group_of_vertex.push_back(scene.group_of_vertex.empty() ? 0
                                                                 : scene.group_of_vertex[static_cast<std::size_t>(v)]);
  part.move(scene.start, scene.end);
  return part;
}

}  // namespace tamis::test
