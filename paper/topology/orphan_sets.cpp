#include "paper/topology/orphan_sets.hpp"

#include <algorithm>

#include "paper/topology/representatives.hpp"

namespace tamis::lab {
namespace {

class Collector {
 public:
  Collector(const Mesh& mesh, Index face_count)
      : mesh_(mesh), triangles_(choose_representatives(mesh)), face_count_(face_count) {}

  /// The representatives of a lost pair share a vertex: so looks at pairs of triangles that share one.
  OrphanSets collect() {
    for (Index a = 0; a < static_cast<Index>(triangles_.size()); ++a)
      for_each_neighbour(a, [&](Index b) {
        if (b < face_count_) collect_vf(a, b);
        if (a < b) collect_ee(a, b);
      });
    return std::move(sets_);
  }

 private:
  const Face& face(Index triangle) const { return mesh_.faces()[static_cast<std::size_t>(triangle)]; }

  /// Triangles that share a vertex with `a`, each once.
  template <class F>
  void for_each_neighbour(Index a, const F& f) {
    neighbours_.clear();
    for (Index v : face(a))
      for (Index b : mesh_.faces_of_vertex(v))
        if (b != a) neighbours_.push_back(b);
    std::sort(neighbours_.begin(), neighbours_.end());
    neighbours_.erase(std::unique(neighbours_.begin(), neighbours_.end()), neighbours_.end());
    for (Index b : neighbours_) f(b);
  }

  bool all_share_a_vertex(std::span<const Index> some, std::span<const Index> others) const {
    return std::all_of(some.begin(), some.end(), [&](Index a) {
      return std::all_of(others.begin(), others.end(), [&](Index b) { return share_a_vertex(face(a), face(b)); });
    });
  }

  void collect_vf(Index a, Index b) {
    const TriangleFeatures& t = triangles_[static_cast<std::size_t>(a)];
    for (std::size_t k = 0; k < 3; ++k) {
      const Index v = t.vertices[k];
      if (!(t.own_vertices >> k & 1) || std::ranges::count(face(b), v)) continue;
      const bool is_orphan = all_share_a_vertex(mesh_.faces_of_vertex(v), std::array{b});
      (is_orphan ? sets_.orphans : sets_.displaced).vf.push_back({v, b});
    }
  }

  void collect_ee(Index a, Index b) {
    const TriangleFeatures &s = triangles_[static_cast<std::size_t>(a)], &t = triangles_[static_cast<std::size_t>(b)];
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        if ((s.own_edges >> i & 1) && (t.own_edges >> j & 1)) collect_edges(s.edges[i], t.edges[j]);
  }

  void collect_edges(Index e0, Index e1) {
    const Edge &a = mesh_.edges()[static_cast<std::size_t>(e0)], &b = mesh_.edges()[static_cast<std::size_t>(e1)];
    if (a[0] == b[0] || a[0] == b[1] || a[1] == b[0] || a[1] == b[1]) return;
    const bool is_orphan = all_share_a_vertex(mesh_.faces_of_edge(e0), mesh_.faces_of_edge(e1));
    (is_orphan ? sets_.orphans : sets_.displaced).ee.push_back({std::min(e0, e1), std::max(e0, e1)});
  }

  const Mesh& mesh_;
  std::vector<TriangleFeatures> triangles_;
  Index face_count_;
  std::vector<Index> neighbours_;
  OrphanSets sets_;
};

}  // namespace

OrphanSets collect_orphan_sets(const Mesh& mesh, Index face_count) { return Collector(mesh, face_count).collect(); }

}  // namespace tamis::lab
