#include "scenes/simulation/zones.hpp"

#include <gtest/gtest.h>

namespace tamis::simulation {
namespace {

Contact contact_of(const std::array<Index, 4>& vertices) {
  return {PairKind::vertex_face, Certainty::certified, vertices, 0.5, 0.5, 0.3, 0.3, {0, 0, 1}};
}

struct Moving {
  Points start = Points::Random(3, 9);
  Particles particles{start + 0.1 * Points::Random(3, 9), Points::Zero(3, 9), Eigen::VectorXd::LinSpaced(9, 1, 3)};
  std::vector<Index> body = std::vector<Index>(9, -1);

  Points displacement() const { return particles.position - start; }
};

const Eigen::Isometry3d kRest = Eigen::Isometry3d::Identity();
const Eigen::Isometry3d kTurn{Eigen::AngleAxisd(0.3, Vec::UnitZ())};

// Bug: members that move differently, momentum lost, or outsiders moved.
TEST(Zones, MoveTogetherWithTheirMomentum) {
  Moving m;
  const Points before = m.displacement();
  Zones zones(9);
  zones.join(std::vector{contact_of({0, 1, 2, 3}), contact_of({3, 4, 5, 6})});
  ASSERT_TRUE(zones.move(m.particles, m.start, m.body, {kRest}));
  EXPECT_EQ(zones.size(), 7);
  Vec momentum = Vec::Zero(), momentum_before = Vec::Zero();
  for (Index v = 0; v < 7; ++v) {
    EXPECT_LT((m.displacement().col(v) - m.displacement().col(0)).norm(), 1e-15);
    momentum += m.displacement().col(v) / m.particles.inverse_mass[v];
    momentum_before += before.col(v) / m.particles.inverse_mass[v];
  }
  EXPECT_LT((momentum - momentum_before).norm(), 1e-14);
  EXPECT_EQ(m.displacement().rightCols(2), before.rightCols(2));
}

// Bug: a zone at an obstacle that does not follow it would be run over.
TEST(Zones, GoWithTheObstacleInThem) {
  Moving m;
  m.body[3] = 1;
  m.particles.position.col(3) = kTurn * m.start.col(3);
  Zones zones(9);
  zones.join(std::vector{contact_of({0, 1, 2, 3})});
  ASSERT_TRUE(zones.move(m.particles, m.start, m.body, {kRest, kTurn}));
  for (Index v = 0; v < 4; ++v) EXPECT_LT((m.particles.position.col(v) - kTurn * m.start.col(v)).norm(), 1e-15);
}

// Bug: choosing one of two obstacles and being run over by the other.
TEST(Zones, RefuseToChooseBetweenObstaclesThatMoveDifferently) {
  Moving m;
  m.body[0] = 0;
  m.body[6] = 1;
  const Points before = m.particles.position;
  Zones zones(9);
  zones.join(std::vector{contact_of({0, 1, 2, 3}), contact_of({3, 4, 5, 6})});
  EXPECT_FALSE(zones.move(m.particles, m.start, m.body, {kRest, kTurn}));
  EXPECT_EQ(m.particles.position, before);
  EXPECT_TRUE(zones.move(m.particles, m.start, m.body, {kTurn, kTurn}));
}

}  // namespace
}  // namespace tamis::simulation
