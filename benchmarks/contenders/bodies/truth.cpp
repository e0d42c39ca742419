#include "benchmarks/contenders/bodies/bodies.hpp"
#include "oracle/bodies.hpp"

namespace tamis::bench {
namespace {

oracle::MovingBody for_oracle(const MovingBody& body) {
  return {body.shape.points, body.shape.faces, {{{0, 0, 0}, body.turn, body.from, body.to}}};
}

}  // namespace

double true_first_contact(const MovingPair& pair) {
  return static_cast<double>(oracle::first_touch(for_oracle(pair.first), for_oracle(pair.second)));
}

}  // namespace tamis::bench
