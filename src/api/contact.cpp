#include "tamis/contact.hpp"

#include <algorithm>
#include <string>

#include "api/pair_faults.hpp"
#include "numbers/floating_point_state.hpp"
#include "tamis/error.hpp"

namespace tamis {
namespace {

constexpr const char* kAdvice = ": give a pair of this mesh, its vertices as in Contact";

Index known_vertex(const Mesh& mesh, Index v) {
  if (v < 0 || v >= mesh.vertex_count())
    throw InvalidMesh("the mesh has " + std::to_string(mesh.vertex_count()) + " vertices and none with the number " +
                      std::to_string(v) + kAdvice);
  return v;
}

Index known_edge(const Mesh& mesh, Index a, Index b) {
  const Index place = mesh.find_edge(known_vertex(mesh, a), known_vertex(mesh, b));
  if (place < 0)
    throw InvalidMesh("the mesh has no edge between the vertices " + std::to_string(a) + " and " + std::to_string(b) +
                      kAdvice);
  return place;
}

std::string text_of(const Face& f) {
  return std::to_string(f[0]) + ", " + std::to_string(f[1]) + ", " + std::to_string(f[2]);
}

/// The mesh's own order of a face's vertices; empty if the mesh has no such face.
std::string known_order(const Mesh& mesh, Face face) {
  std::sort(face.begin(), face.end());
  do
    if (mesh.find_face(face) >= 0) return text_of(face);
  while (std::next_permutation(face.begin(), face.end()));
  return "";
}

Index known_face(const Mesh& mesh, const Face& face) {
  for (const Index v : face) known_vertex(mesh, v);
  const Index place = mesh.find_face(face);
  if (place >= 0) return place;
  const std::string other = known_order(mesh, face);
  throw InvalidMesh("the mesh has no face of the vertices " + text_of(face) +
                    (other.empty() ? kAdvice : " in this order, but " + other + ": give them so"));
}

}  // namespace

std::array<Index, 2> features_of(const Mesh& mesh, PairKind kind, const std::array<Index, 4>& v) {
  switch (kind) {
    case PairKind::vertex_face:
      return {known_vertex(mesh, v[0]), known_face(mesh, {v[1], v[2], v[3]})};
    case PairKind::edge_edge:
      return {known_edge(mesh, v[0], v[1]), known_edge(mesh, v[2], v[3])};
    case PairKind::vertex_edge:
      return {known_vertex(mesh, v[0]), known_edge(mesh, v[1], v[2])};
    case PairKind::vertex_vertex:
      return {known_vertex(mesh, v[0]), known_vertex(mesh, v[1])};
  }
  throw InvalidMesh(no_such_kind(kind));
}

std::array<double, 4> weights_of(PairKind kind, double u, double v) {
  const ComputingState state;
  switch (kind) {
    case PairKind::vertex_face:
      return {1, u + v - 1, -u, -v};
    case PairKind::edge_edge:
      return {1 - u, u, v - 1, -v};
    case PairKind::vertex_edge:
      return {1, u - 1, -u, 0};
    case PairKind::vertex_vertex:
      return {1, -1, 0, 0};
  }
  throw Error(no_such_kind(kind));
}

}  // namespace tamis
