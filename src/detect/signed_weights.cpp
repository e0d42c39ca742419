#include "detect/pair_faults.hpp"
#include "tamis/contact.hpp"
#include "tamis/error.hpp"

namespace tamis {

std::array<double, 4> weights_of(PairKind kind, double u, double v) {
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
