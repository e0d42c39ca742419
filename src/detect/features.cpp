#include "motion/pair_kinds.hpp"
#include "tamis/contact.hpp"

namespace tamis {

FeaturePair features_of(const Mesh& mesh, PairKind kind, const std::array<Index, 4>& v) {
  switch (kind) {
    case PairKind::vertex_face:
      return {v[0], mesh.find_face({v[1], v[2], v[3]})};
    case PairKind::edge_edge:
      return {mesh.find_edge(v[0], v[1]), mesh.find_edge(v[2], v[3])};
    case PairKind::vertex_edge:
      return {v[0], mesh.find_edge(v[1], v[2])};
    case PairKind::vertex_vertex:
      break;
  }
  return {v[0], v[1]};
}

}  // namespace tamis
