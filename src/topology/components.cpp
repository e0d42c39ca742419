#include "tamis/components.hpp"

#include <numeric>

namespace tamis {
namespace {

/// Union-find over the vertices.
class Forest {
 public:
  explicit Forest(Index vertices) : parent_(static_cast<std::size_t>(vertices)) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  Index root(Index v) {
    while (parent(v) != v) v = parent(v) = parent(parent(v));
    return v;
  }
  void join(Index a, Index b) { parent(root(a)) = root(b); }

 private:
  Index& parent(Index v) { return parent_[static_cast<std::size_t>(v)]; }
  std::vector<Index> parent_;
};

}  // namespace

Components components_of(const Mesh& mesh) {
  Forest forest(mesh.vertex_count());
  for (const Face& f : mesh.faces()) {
    forest.join(f[0], f[1]);
    forest.join(f[1], f[2]);
  }
  for (const Edge& e : mesh.edges()) forest.join(e[0], e[1]);

  Components components;
  components.of_vertex.assign(static_cast<std::size_t>(mesh.vertex_count()), -1);
  std::vector<Index> number(static_cast<std::size_t>(mesh.vertex_count()), -1);
  for (const Index v : mesh.points()) {
    Index& component = number[static_cast<std::size_t>(forest.root(v))];
    if (component < 0) component = components.count++;
    components.of_vertex[static_cast<std::size_t>(v)] = component;
  }
  return components;
}

}  // namespace tamis
