#include "tamis/mesh.hpp"

#include <algorithm>
#include <numeric>
#include <string>

#include "search/topology/at.hpp"
#include "search/topology/countable.hpp"
#include "search/topology/rows.hpp"
#include "tamis/error.hpp"

namespace tamis {
namespace {

void check_vertex_count(Index vertex_count) {
  if (vertex_count < 0)
    throw InvalidMesh("the number of vertices is " + std::to_string(vertex_count) +
                      ": give as many as there are positions");
}

void check_index(Index index, Index vertex_count, const char* what, std::size_t element) {
  if (index >= 0 && index < vertex_count) return;
  throw InvalidMesh(std::string(what) + " " + std::to_string(element) + " names vertex " + std::to_string(index) +
                    ", but there are " + std::to_string(vertex_count) +
                    " vertices: indices must be in [0, vertex count)" +
                    (index == vertex_count ? "; if yours count from 1, subtract 1" : ""));
}

template <class Elements>
void check_indices(const Elements& elements, Index vertex_count, const char* what) {
  for (std::size_t i = 0; i < elements.size(); ++i)
    for (Index index : elements[i]) check_index(index, vertex_count, what, i);
}

Edge ascending(Index a, Index b) { return a < b ? Edge{a, b} : Edge{b, a}; }

/// An edge, as a side of a face or as a loose edge.
struct FaceSide {
  Edge edge;
  Index face;  ///< -1 for a loose edge
  Index side;
};

/// Sides of faces and loose edges, sorted by edge. A counting sort by first vertex comes first, then a sort in each
/// bucket.
std::vector<FaceSide> collect_sides(Index vertex_count, const std::vector<Face>& faces,
                                    const std::vector<Edge>& loose_edges) {
  const auto for_each = [&](const auto& f) {
    for (std::size_t face = 0; face < faces.size(); ++face)
      for (std::size_t k = 0; k < 3; ++k) {
        const Index a = faces[face][k], b = faces[face][(k + 1) % 3];
        if (a != b) f(FaceSide{ascending(a, b), static_cast<Index>(face), static_cast<Index>(k)});
      }
    for (const Edge& edge : loose_edges)
      if (edge[0] != edge[1]) f(FaceSide{ascending(edge[0], edge[1]), -1, 0});
  };
  std::vector<std::size_t> bucket_end(at(vertex_count) + 1, 0);  // [v]: end of bucket v - 1 until v is filled
  for_each([&](const FaceSide& side) { ++bucket_end[at(side.edge[0]) + 1]; });
  std::partial_sum(bucket_end.begin(), bucket_end.end(), bucket_end.begin());
  std::vector<FaceSide> sides(bucket_end.back());
  for_each([&](const FaceSide& side) { sides[bucket_end[at(side.edge[0])]++] = side; });
  auto first = sides.begin();
  for (std::size_t v = 0; v < at(vertex_count); ++v) {
    const auto last = sides.begin() + static_cast<std::ptrdiff_t>(bucket_end[v]);
    std::sort(first, last, [](const FaceSide& a, const FaceSide& b) { return a.edge[1] < b.edge[1]; });
    first = last;
  }
  return sides;
}

/// For each vertex (edge), the faces that have it, once each; `corners`: each face's three vertices (edges), or -1.
IndexRows faces_by(Index count, const std::vector<std::array<Index, 3>>& corners) {
  const auto is_repeated = [](const std::array<Index, 3>& of_face, std::size_t k) {
    return (k > 0 && of_face[k] == of_face[0]) || (k == 2 && of_face[2] == of_face[1]);
  };
  return rows_of(count, [&](const auto& add) {
    for (std::size_t f = 0; f < corners.size(); ++f)
      for (std::size_t k = 0; k < 3; ++k)
        if (corners[f][k] >= 0 && !is_repeated(corners[f], k)) add(corners[f][k], static_cast<Index>(f));
  });
}

}  // namespace

Mesh::Mesh(Index vertex_count, std::vector<Face> faces, const std::vector<Edge>& loose_edges,
           std::vector<Index> loose_points)
    : vertex_count_(vertex_count), faces_(std::move(faces)) {
  check_vertex_count(vertex_count);
  require_countable(faces_.size(), loose_edges.size());
  check_indices(faces_, vertex_count, "face");
  check_indices(loose_edges, vertex_count, "loose edge");
  for (std::size_t i = 0; i < loose_points.size(); ++i) check_index(loose_points[i], vertex_count, "loose point", i);
  if (faces_.empty() && loose_edges.empty() && loose_points.empty())
    throw InvalidMesh("the mesh has no face, no edge and no point: give at least one feature");

  edges_of_face_.assign(faces_.size(), {-1, -1, -1});
  for (const FaceSide& side : collect_sides(vertex_count, faces_, loose_edges)) {
    if (edges_.empty() || edges_.back() != side.edge) edges_.push_back(side.edge);
    if (side.face >= 0) edges_of_face_[at(side.face)][at(side.side)] = number_of(edges_.size() - 1);
  }
  IndexRows of_edge = faces_by(number_of(edges_.size()), edges_of_face_), of_vertex = faces_by(vertex_count, faces_);
  faces_of_edges_ = std::move(of_edge.items);
  first_face_of_edge_ = std::move(of_edge.offsets);
  faces_of_vertices_ = std::move(of_vertex.items);
  first_face_of_vertex_ = std::move(of_vertex.offsets);

  std::vector<bool> used(at(vertex_count), false);
  for (const Face& face : faces_)
    for (Index v : face) used[at(v)] = true;
  for (const Edge& edge : loose_edges) used[at(edge[0])] = used[at(edge[1])] = true;
  for (Index v : loose_points) used[at(v)] = true;
  for (Index v = 0; v < vertex_count; ++v)
    if (used[at(v)]) points_.push_back(v);
}

Index Mesh::find_edge(Index a, Index b) const {
  const Edge edge = ascending(a, b);
  const auto found = std::lower_bound(edges_.begin(), edges_.end(), edge);
  return found != edges_.end() && *found == edge ? number_of(static_cast<std::size_t>(found - edges_.begin())) : -1;
}

Index Mesh::find_face(const Face& face) const {
  if (face[0] < 0 || face[0] >= vertex_count_) return -1;
  const auto row = faces_of_vertex(face[0]);
  const auto found = std::find_if(row.begin(), row.end(), [&](Index f) { return faces_[at(f)] == face; });
  return found != row.end() ? *found : -1;
}

}  // namespace tamis
