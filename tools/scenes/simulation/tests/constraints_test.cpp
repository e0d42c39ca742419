#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "scenes/simulation/model.hpp"
#include "scenes/simulation/touch.hpp"
#include "tamis/pair.hpp"

namespace tamis::simulation {
namespace {

constexpr double kStep = 0.002;

/// Points in the unit cube with different masses.
Particles random_particles(int count, std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  Particles particles;
  particles.position = Points::NullaryExpr(3, count, [&] { return unit(engine); });
  particles.velocity.setZero(3, count);
  particles.inverse_mass = Eigen::VectorXd::NullaryExpr(count, [&] { return 0.5 + unit(engine); });
  return particles;
}

/// What a move adds to the momentum and to the angular momentum, times the step's length.
struct Momentum {
  Vec linear, angular;
};

template <class Move>
Momentum momentum_of(Particles& particles, Move move) {
  const Points before = particles.position;
  move();
  Momentum sum{Vec::Zero(), Vec::Zero()};
  for (Index v = 0; v < particles.count(); ++v) {
    const Vec moved = (particles.position.col(v) - before.col(v)) / particles.inverse_mass[v];
    sum.linear += moved;
    sum.angular += Vec(before.col(v)).cross(moved);
  }
  return sum;
}

Points flat_hinge() {
  Points rest(3, 4);
  rest << 0, 1, 0.4, 0.7,  //
      0, 0, 0.8, -0.9,     //
      0, 0, 0, 0;
  return rest;
}

Points corner() {
  Points rest(3, 5);
  rest << 0, 1, 0, 0, 0.2,  //
      0, 0, 1, 0, 0.3,      //
      0, 0, 0, 1, 0.1;
  return rest;
}

// Bug: a gradient or an inverse mass used for the wrong vertex: the constraint would push the whole body away.
TEST(Constraints, ConserveMomentum) {
  Particles p = random_particles(5, 1);
  Distance distance{0, 1, 0.3, 1e-4};
  Bend bend = make_bend({0, 1, 2, 3}, flat_hinge(), 0.1);
  Attachment attachment = make_attachment({4, 0, 1, 2, 3}, corner());
  for (int i = 0; i < 3; ++i) {
    EXPECT_LT(momentum_of(p, [&] { distance.project(p, kStep); }).linear.norm(), 1e-12);
    EXPECT_LT(momentum_of(p, [&] { bend.project(p, kStep); }).linear.norm(), 1e-12);
    EXPECT_LT(momentum_of(p, [&] { attachment.project(p, kStep); }).linear.norm(), 1e-12);
  }
}

// Bug: a push that is not along the line between the points makes a free body spin.
TEST(Constraints, StretchAndSolidsConserveAngularMomentum) {
  Particles p = random_particles(4, 2);
  Distance distance{0, 1, 0.3, 1e-4};
  EXPECT_LT(momentum_of(p, [&] { distance.project(p, kStep); }).angular.norm(), 1e-12);
  Tetrahedron solid({0, 1, 2, 3}, corner(), {1e3, 2e3});
  p.position = corner().leftCols(4) + 0.2 * p.position;
  const Momentum given = momentum_of(p, [&] { solid.project(p, kStep); });
  EXPECT_LT(given.linear.norm(), 1e-12);
  EXPECT_LT(given.angular.norm(), 1e-5);  // the rotation is found to 1e-6
}

// Bug: compliance left out, or taken for stiffness.
TEST(Constraints, AStiffEdgeTakesItsLengthInOneProjection) {
  Particles p = random_particles(2, 3);
  Distance stiff{0, 1, 0.3, 0};
  stiff.project(p, kStep);
  EXPECT_NEAR((p.position.col(0) - p.position.col(1)).norm(), 0.3, 1e-12);
  Distance soft{0, 1, 0.6, 1e9};
  soft.project(p, kStep);
  EXPECT_NEAR((p.position.col(0) - p.position.col(1)).norm(), 0.3, 1e-9);
}

// Bug: wrong cotangents: flat cloth would curl by itself, or a fold would cost nothing.
TEST(Constraints, BendingIsBlindToRigidMotionAndResistsFolding) {
  const Points rest = flat_hinge();
  Bend bend = make_bend({0, 1, 2, 3}, rest, 1e6);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.1, Vec(1, 2, -1).normalized()).toRotationMatrix();
  Particles p = random_particles(4, 4);
  p.position = (turn * rest).colwise() + Vec(3, 1, 2);
  const Points before = p.position;
  bend.project(p, kStep);
  EXPECT_LT((p.position - before).norm(), 1e-12);

  p.position = rest;
  p.position(2, 2) = p.position(2, 3) = 0.3;
  bend.project(p, kStep);
  EXPECT_LT(p.position(2, 2) - p.position(2, 0), 0.2);
}

// Bug: a body that swells, shrinks or creeps while nothing acts on it.
TEST(Constraints, ASolidAtRestStaysAtRest) {
  const Points rest = corner().leftCols(4);
  Tetrahedron solid({0, 1, 2, 3}, rest, {2e4, 4e4});
  Particles p = random_particles(4, 5);
  p.position = rest;
  for (int i = 0; i < 20; ++i) solid.project(p, kStep);
  EXPECT_LT((p.position - rest).norm(), 1e-12);
  EXPECT_NEAR(solid.rest_volume(), 1.0 / 6, 1e-15);
}

// Bug: energy with a second minimum at the mirror image.
TEST(Constraints, ASolidTurnedInsideOutRecovers) {
  const Points rest = corner().leftCols(4);
  Tetrahedron solid({0, 1, 2, 3}, rest, {2e4, 4e4});
  Particles p = random_particles(4, 6);
  p.position = rest;
  p.position(2, 3) = -0.8;
  for (int i = 0; i < 300; ++i) {
    solid.reset();
    solid.project(p, 0.1);
  }
  Eigen::Matrix3d sides;
  for (int i = 0; i < 3; ++i) sides.col(i) = p.position.col(i + 1) - p.position.col(0);
  EXPECT_NEAR(sides.determinant(), 1, 1e-3);
  EXPECT_NEAR((p.position.col(1) - p.position.col(2)).norm(), std::sqrt(2.0), 1e-3);
}

// Bug: embedded points that do not follow their tetrahedron.
TEST(Constraints, AnEmbeddedPointFollowsItsTetrahedron) {
  Points rest(3, 5);
  rest << corner().rightCols(1), corner().leftCols(4);
  Attachment attachment = make_attachment({0, 1, 2, 3, 4}, rest);
  const Eigen::Matrix3d affine = (Eigen::Matrix3d() << 2, 1, 0, 0, 1, 0.5, 0.3, 0, 1.5).finished();
  Particles p = random_particles(5, 7);
  p.position = (affine * rest).colwise() + Vec(1, 2, 3);
  const Vec expected = p.position.col(0);
  p.inverse_mass.tail(4).setZero();
  p.position.col(0) = Vec(9, 9, 9);
  attachment.project(p, kStep);
  EXPECT_LT((p.position.col(0) - expected).norm(), 1e-12);
}

// Bug: a gas that pushes its bag through the room, or pulls instead of pushing.
TEST(Constraints, GasPushesOutwardsAndNowhereElse) {
  Model model;
  const Surface bag = ball(4, 0.2);
  model.add_cloth(bag, bag, {0.2, 1000, 0});
  const Gas gas{model.faces, 100, 1, 0.1};
  EXPECT_NEAR(gas.volume(model.particles.position), 4.19 * 0.008, 0.1 * 4.19 * 0.008);
  gas.accelerate(model.particles, 1, kStep);
  Vec momentum = Vec::Zero();
  for (Index v = 0; v < model.particles.count(); ++v) {
    EXPECT_GT(model.particles.velocity.col(v).dot(model.particles.position.col(v)), 0);
    momentum += model.particles.velocity.col(v) / model.particles.inverse_mass[v];
  }
  EXPECT_LT(momentum.norm(), 1e-12);
}

/// A point above the middle of a triangle at z = 0, moving by `move`.
struct Fall {
  Points start{3, 4};
  Particles particles = random_particles(4, 8);
  Touch touch;

  Fall(double height, const Vec& move, double thickness) {
    start << 0.3, 0, 1, 0,  //
        0.3, 0, 0, 1,       //
        height, 0, 0, 0;
    particles.position = start;
    particles.position.col(0) += move;
    find_touch(thickness);
  }
  /// Of the contact of this very step; one that the pair does not reach stands where it would.
  void find_touch(double thickness) {
    std::array<Point, 4> from, to;
    for (Index i = 0; i < 4; ++i) {
      const auto at = [&](const Points& x) { return Point{x(0, i), x(1, i), x(2, i)}; };
      from[static_cast<std::size_t>(i)] = at(start);
      to[static_cast<std::size_t>(i)] = at(particles.position);
    }
    const PairResult r = vertex_face(from, to, {0.001});
    ASSERT_TRUE(r.touches);
    touch = make_touch({PairKind::vertex_face, r.certainty, {0, 1, 2, 3}, r.toi_lower, r.toi_upper, r.u, r.v, r.normal},
                       start, thickness);
  }
  double gap() const {
    const auto& x = particles.position;
    return touch.normal.dot(x.col(0) * touch.weights[0] + x.col(1) * touch.weights[1] + x.col(2) * touch.weights[2] +
                            x.col(3) * touch.weights[3]);
  }
};

// Bug: the normal of the face taken as it is, whatever side the point came from; a gap that is not kept.
TEST(Touches, KeepTheFeaturesApartOnTheSideTheyCameFrom) {
  for (const double side : {1.0, -1.0}) {
    Fall fall(0.05, {0, 0, -0.2}, 0.01);
    if (side < 0) {  // seen upside down
      fall.start.row(2) *= -1;
      fall.particles.position.row(2) *= -1;
      fall.find_touch(0.01);
    }
    EXPECT_NEAR(fall.touch.normal.z(), side, 1e-12);
    EXPECT_LT(fall.gap(), 0);
    const Momentum given = momentum_of(fall.particles, [&] { project(fall.touch, fall.particles, fall.start, 0); });
    EXPECT_NEAR(fall.gap(), 0.01, 1e-12);
    EXPECT_LT(given.linear.norm(), 1e-12);
  }
}

// Bug: features found too close are shot apart within one step.
TEST(Touches, RegainThicknessLittleByLittle) {
  Fall fall(0.001, {0, 0, -1e-4}, 0.01);
  project(fall.touch, fall.particles, fall.start, 0);
  EXPECT_GT(fall.gap(), 0.001);
  EXPECT_LT(fall.gap(), 0.002);
}

// Bug: friction that reverses the sliding, or grows beyond Coulomb's bound.
TEST(Touches, FrictionHoldsOrSlowsButNeverReverses) {
  Fall sticking(0.05, {0.01, 0, -0.2}, 0.01), sliding(0.05, {0.5, 0, -0.2}, 0.01);
  for (Fall* fall : {&sticking, &sliding}) {
    fall->particles.inverse_mass.tail(3).setZero();
    project(fall->touch, fall->particles, fall->start, 0.5);
  }
  const Vec stuck = sticking.particles.position.col(0) - sticking.start.col(0);
  EXPECT_LT((stuck - sticking.touch.normal.dot(stuck) * sticking.touch.normal).norm(), 1e-12);
  const Vec slid = sliding.particles.position.col(0) - sliding.start.col(0);
  EXPECT_GT(slid.x(), 0.3);
  EXPECT_LT(slid.x(), 0.5);
}

}  // namespace
}  // namespace tamis::simulation
