#include "tamis/components.hpp"

#include <numeric>

#include "search/topology/at.hpp"
#include "search/topology/countable.hpp"
#include "search/topology/neighbours.hpp"

namespace tamis {
namespace {

/// Union-find over the vertices.
class Forest {
 public:
  explicit Forest(Index vertices) : parent_(at(vertices)) { std::iota(parent_.begin(), parent_.end(), 0); }
  Index root(Index v) {
    while (parent(v) != v) v = parent(v) = parent(parent(v));
    return v;
  }
  void join(Index a, Index b) { parent(root(a)) = root(b); }

 private:
  Index& parent(Index v) { return parent_[at(v)]; }
  std::vector<Index> parent_;
};

}  // namespace

Components components_of(const Mesh& mesh) {
  Forest forest(mesh.vertex_count());
  for (const Edge& e : mesh.edges()) forest.join(e[0], e[1]);  // sides of faces among them

  Components components;
  components.of_vertex.assign(at(mesh.vertex_count()), -1);
  std::vector<Index> number(at(mesh.vertex_count()), -1);
  for (const Index v : mesh.points()) {
    Index& component = number[at(forest.root(v))];
    if (component < 0) component = components.count++;
    components.of_vertex[at(v)] = component;
  }
  return components;
}

IndexRows neighbours_of(const Mesh& mesh) {
  require_countable_ends(mesh.edges().size());
  return rows_of(mesh.vertex_count(), [edges = mesh.edges()](const auto& add) {
    for (std::size_t e = edges.size(); e-- > 0;) {
      add(edges[e][0], edges[e][1]);
      add(edges[e][1], edges[e][0]);
    }
  });
}

}  // namespace tamis
