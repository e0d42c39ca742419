// Asks the library about one pair of any kind.
#pragma once
#include "oracle/oracle.hpp"
#include "tamis/pair.hpp"

namespace tamis::test {

inline constexpr std::array kAllKinds{PairKind::vertex_face, PairKind::edge_edge, PairKind::vertex_edge,
                                      PairKind::vertex_vertex};
static_assert(kAllKinds.size() == kPairKinds, "tests ask all kinds: name the new one");

inline PairResult ask_pair(PairKind kind, const oracle::Motion& m, const PairOptions& options) {
  switch (kind) {
    case PairKind::vertex_face:
      return vertex_face(m.start, m.end, options);
    case PairKind::edge_edge:
      return edge_edge(m.start, m.end, options);
    case PairKind::vertex_edge:
      return vertex_edge({m.start[0], m.start[1], m.start[2]}, {m.end[0], m.end[1], m.end[2]}, options);
    case PairKind::vertex_vertex:
      break;
  }
  return vertex_vertex({m.start[0], m.start[1]}, {m.end[0], m.end[1]}, options);
}

}  // namespace tamis::test
