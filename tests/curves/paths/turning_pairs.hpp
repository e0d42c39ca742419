// Pairs of features of turning bodies, for the library and for the oracle.
#pragma once
#include <numbers>

#include "oracle/turning.hpp"
#include "scenes/random.hpp"
#include "tamis/rigid_path.hpp"

namespace tamis::test {

using oracle::Turning;
using oracle::TurningPair;
using scenes::Random;

inline constexpr double kPi = std::numbers::pi;

inline RigidPath path_of(const TurningPair& pair) {
  const auto chain = [](const Turning& b) { return interpolated_chain({b.p0, b.theta0}, {b.p1, b.theta1}); };
  const Index second = pair.kind == PairKind::vertex_face ? 1 : 2;
  std::vector<Index> bodies;
  for (Index v = 0; v < 4; ++v) bodies.push_back(v < second ? 0 : 1);
  return {{pair.points.begin(), pair.points.end()}, bodies, {chain(pair.first), chain(pair.second)}};
}

inline PairResult ask(const TurningPair& pair, const PairOptions& options = {}) {
  constexpr std::array<Index, 4> kVertices{0, 1, 2, 3};
  const RigidPath path = path_of(pair);
  return pair.kind == PairKind::vertex_face ? vertex_face(path, kVertices, options)
                                            : edge_edge(path, kVertices, options);
}

}  // namespace tamis::test
