#include "search/topology/closed_parts.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "search/topology/at.hpp"
#include "tamis/components.hpp"

namespace tamis {
namespace {

/// True if two vertices are one. Then the face encloses nothing.
bool is_folded(const Face& face) { return face[0] == face[1] || face[1] == face[2] || face[2] == face[0]; }

/// A side of a face, in the order of the smaller vertex. `direction`: 1 if the face goes from the smaller to the
/// greater vertex, else -1.
struct DirectedSide {
  Edge edge;
  Index component;
  int direction;
};

std::vector<DirectedSide> directed_sides_of(std::span<const Face> faces,
                                            const std::vector<Index>& component_of_vertex) {
  std::vector<DirectedSide> sides;
  for (const Face& face : faces) {
    if (is_folded(face)) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const Index a = face[i], b = face[(i + 1) % 3];
      sides.push_back({{std::min(a, b), std::max(a, b)}, component_of_vertex[at(a)], a < b ? 1 : -1});
    }
  }
  std::ranges::sort(sides, {}, &DirectedSide::edge);
  return sides;
}

/// What closes a component: nothing, an even number of faces at each edge, or as many in each direction.
enum class Closing : std::uint8_t { open, even, wound };

std::vector<Closing> closings_of(const std::vector<DirectedSide>& sides, Index components) {
  std::vector<Closing> closings(at(components), Closing::open);
  for (const DirectedSide& side : sides) closings[at(side.component)] = Closing::wound;
  for (std::size_t i = 0, next = 0; i < sides.size(); i = next) {
    int sum = 0;
    for (next = i; next < sides.size() && sides[next].edge == sides[i].edge; ++next) sum += sides[next].direction;
    const Closing here = (next - i) % 2 != 0 ? Closing::open : sum != 0 ? Closing::even : Closing::wound;
    Closing& closing = closings[at(sides[i].component)];
    closing = std::min(closing, here);
  }
  return closings;
}

/// The vertices of edges with an odd number of faces. Folded faces do not count there, so their vertices are among
/// them.
std::vector<Index> vertices_at_open_edges(const Mesh& mesh) {
  std::vector<Index> vertices;
  for (std::size_t e = 0; e < mesh.edges().size(); ++e)
    if (mesh.faces_of_edge(static_cast<Index>(e)).size() % 2 != 0)
      vertices.insert(vertices.end(), mesh.edges()[e].begin(), mesh.edges()[e].end());
  for (const Face& face : mesh.faces())
    if (is_folded(face)) vertices.insert(vertices.end(), face.begin(), face.end());
  return vertices;
}

/// Joins vertices at one place, if edges there are open. An edge that is closed needs no other: a body that deforms may
/// move it away, and what else is at its place may be open. Returns for each vertex the first of those it is joined to.
std::vector<Index> joined_vertices(const Mesh& mesh, std::span<const Point> points,
                                   std::vector<std::array<Index, 2>>& seams) {
  std::vector<Index> joined(at(mesh.vertex_count()));
  std::iota(joined.begin(), joined.end(), 0);
  std::vector<Index> ordered = vertices_at_open_edges(mesh);
  std::ranges::sort(ordered, [&](Index a, Index b) { return std::tie(points[at(a)], a) < std::tie(points[at(b)], b); });
  for (std::size_t i = 1; i < ordered.size(); ++i) {
    const Index vertex = ordered[i], before = ordered[i - 1];
    if (vertex == before || points[at(vertex)] != points[at(before)]) continue;
    joined[at(vertex)] = joined[at(before)];
    seams.push_back({joined[at(vertex)], vertex});
  }
  return joined;
}

Mesh joined_mesh(const Mesh& mesh, const std::vector<Index>& joined) {
  std::vector<Face> faces(mesh.faces().begin(), mesh.faces().end());
  for (Face& face : faces)
    for (Index& v : face) v = joined[at(v)];
  std::vector<Edge> edges(mesh.edges().begin(), mesh.edges().end());
  for (Edge& edge : edges)
    for (Index& v : edge) v = joined[at(v)];
  std::vector<Index> points;
  for (const Index v : mesh.points()) points.push_back(joined[at(v)]);
  return {mesh.vertex_count(), std::move(faces), edges, std::move(points)};
}

}  // namespace

ClosedParts::ClosedParts(const Mesh& given, std::span<const Point> points) {
  const Mesh mesh = joined_mesh(given, joined_vertices(given, points, seams));
  const Components components = components_of(mesh);
  one_vertex_of_each.assign(at(components.count), kOpen);
  for (const Index v : mesh.points())
    if (Index& first = one_vertex_of_each[at(components.of_vertex[at(v)])]; first == kOpen) first = v;

  const std::vector<Closing> closings =
      closings_of(directed_sides_of(mesh.faces(), components.of_vertex), components.count);
  std::vector<Index> number(closings.size(), kOpen);
  for (std::size_t i = 0; i < closings.size(); ++i)
    if (closings[i] != Closing::open) number[i] = closings[i] == Closing::wound ? kWound : count++;
  is_closed_ = true;
  for (const Face& face : mesh.faces()) {
    const Index part = number[at(components.of_vertex[at(face[0])])];
    part_of_face.push_back(is_folded(face) ? kOpen : part);
    is_closed_ = is_closed_ && (part != kOpen || is_folded(face));
    encloses_ = encloses_ || part_of_face.back() != kOpen;
  }
  is_closed_ = is_closed_ && encloses_;
}

}  // namespace tamis
