#include "audit/collapsed.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace tamis::audit {
namespace {

constexpr std::size_t kFewVertices = 10;

/// Along how many axes some points have one coordinate.
class Extent {
 public:
  void add(Index vertex, const double* p) {
    if (count_++ == 0) {
      first_ = {p[0], p[1], p[2]};
      vertex_ = vertex;
    }
    for (std::size_t k = 0; k < 3; ++k) varies_[k] = varies_[k] || p[k] != first_[k];
  }
  std::size_t count() const { return count_; }
  Index first_vertex() const { return vertex_; }
  std::ptrdiff_t fixed_axes() const { return std::count(varies_.begin(), varies_.end(), false); }

 private:
  std::size_t count_ = 0;
  Index vertex_ = 0;
  Point first_{};
  std::array<bool, 3> varies_{};
};

std::size_t index_of(Index i) { return static_cast<std::size_t>(i); }

/// The vertex that an edge of the face leaves.
Index third_vertex(const Face& face, const Edge& edge) {
  return *std::find_if(face.begin(), face.end(), [&](Index v) { return v != edge[0] && v != edge[1]; });
}

bool has_three_vertices(const Face& f) { return f[0] != f[1] && f[1] != f[2] && f[2] != f[0]; }

/// By component: are there triangles that share an edge, but not the third vertex? On a line two such triangles touch.
/// If neither third vertex lies in the other triangle, these vertices are the ends of all four, on both sides of the
/// shared edge, and the edge from each of them to the farther end of the shared one covers that.
std::vector<bool> with_folds(const Mesh& mesh, const Components& components) {
  std::vector<bool> result(index_of(components.count));
  for (std::size_t e = 0; e < mesh.edges().size(); ++e) {
    const Edge& edge = mesh.edges()[e];
    Index other = -1;
    for (const Index f : mesh.faces_of_edge(static_cast<Index>(e))) {
      const Face& face = mesh.faces()[index_of(f)];
      if (!has_three_vertices(face)) continue;
      const Index third = third_vertex(face, edge);
      if (other >= 0 && third != other) result[index_of(components.of_vertex[index_of(edge[0])])] = true;
      other = third;
    }
  }
  return result;
}

std::string sentence_of(const std::vector<Extent>& extents, const std::vector<bool>& collapsed) {
  const auto count = std::count(collapsed.begin(), collapsed.end(), true);
  const auto first =
      index_of(static_cast<Index>(std::find(collapsed.begin(), collapsed.end(), true) - collapsed.begin()));
  const std::string where = extents[first].fixed_axes() == 3 ? " lie at one point" : " lie on one line";
  if (extents.size() == 1) return "all vertices" + where;
  const std::string more = count > 1 ? ", and of " + std::to_string(count - 1) + " more" : "";
  return "all vertices of the object with vertex " + std::to_string(extents[first].first_vertex()) + where + more;
}

}  // namespace

Collapsed collapsed_in(const Mesh& mesh, const Components& components, const Positions& positions) {
  Extent all;
  std::vector<Extent> extents(index_of(components.count));
  for (const Index v : mesh.points()) {
    all.add(v, positions[v]);
    extents[index_of(components.of_vertex[index_of(v)])].add(v, positions[v]);
  }
  if (mesh.faces().empty()) return {};
  if (all.fixed_axes() == 3 && all.count() >= kFewVertices)
    return {std::vector<bool>(extents.size(), true), "all vertices lie at one point"};
  std::vector<bool> has_face(extents.size());
  for (const Face& face : mesh.faces()) has_face[index_of(components.of_vertex[index_of(face[0])])] = true;
  const auto may_have_collapsed = [&](std::size_t i) {
    return has_face[i] && extents[i].count() >= kFewVertices && extents[i].fixed_axes() >= 2;
  };
  std::vector<bool> collapsed(extents.size()), folded;
  for (std::size_t i = 0; i < extents.size(); ++i) {
    if (!may_have_collapsed(i)) continue;
    if (extents[i].fixed_axes() == 2 && folded.empty()) folded = with_folds(mesh, components);
    collapsed[i] = extents[i].fixed_axes() == 3 || folded[i];
  }
  if (std::find(collapsed.begin(), collapsed.end(), true) == collapsed.end()) return {};
  std::string sentence = sentence_of(extents, collapsed);
  return {std::move(collapsed), std::move(sentence)};
}

std::optional<Mesh> without(const Mesh& mesh, const Components& components, const std::vector<bool>& left_out) {
  const auto is_kept = [&](Index v) { return !left_out[index_of(components.of_vertex[index_of(v)])]; };
  std::vector<Face> faces;
  std::vector<Edge> edges;
  std::vector<Index> points;
  std::copy_if(mesh.faces().begin(), mesh.faces().end(), std::back_inserter(faces),
               [&](const Face& face) { return is_kept(face[0]); });
  std::copy_if(mesh.edges().begin(), mesh.edges().end(), std::back_inserter(edges),
               [&](const Edge& edge) { return is_kept(edge[0]); });
  std::copy_if(mesh.points().begin(), mesh.points().end(), std::back_inserter(points), is_kept);
  if (points.empty()) return {};
  return Mesh(mesh.vertex_count(), std::move(faces), edges, std::move(points));
}

}  // namespace tamis::audit
