// The normal of a contact: which way the first feature must go. Of closest points against a search that shares nothing
// with the library; of crossings, and in degenerate cases, by what holds of any first contact: there the features
// approach. By hand where they only graze, start in contact, or stay in one plane.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "pair/motion/pair_kinds.hpp"
#include "support/ask_pair.hpp"
#include "support/case_name.hpp"
#include "support/test_data.hpp"
#include "tamis/path.hpp"
#include "tamis/spline_path.hpp"

namespace tamis::test {
namespace {

using oracle::Motion;
using Real = long double;
using Vector = std::array<Real, 3>;

Real dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Real length(const Vector& a) { return std::sqrt(dot(a, a)); }

/// Of the pair's vertices: what leads from the second feature's point to the first's.
std::array<Real, 4> weights_of(PairKind kind, Real u, Real v) {
  if (kind == PairKind::edge_edge) return {1 - u, u, v - 1, -v};
  return {1, u + v - 1, -u, -v};
}

template <class VertexAt>
Vector gap_of(PairKind kind, Real u, Real v, const VertexAt& vertex_at) {
  const auto weights = weights_of(kind, u, v);
  Vector gap{};
  for (std::size_t i = 0; i < vertex_count(kind); ++i)
    for (std::size_t k = 0; k < 3; ++k) gap[k] += weights[i] * vertex_at(i, k);
  return gap;
}

Real size_of(PairKind kind, const Motion& m) {
  Real size = 0;
  for (const auto* points : {&m.start, &m.end})
    for (std::size_t i = 1; i < vertex_count(kind); ++i)
      for (std::size_t k = 0; k < 3; ++k)
        size = std::max<Real>(size, std::abs(Real((*points)[i][k]) - Real((*points)[0][k])));
  return size;
}

/// Relative to the first vertex: what is far from the origin keeps its bits.
Vector gap_at(PairKind kind, const Motion& m, Real t, Real u, Real v) {
  return gap_of(kind, u, v, [&](std::size_t i, std::size_t k) {
    const auto from = [&](const std::array<Point, 4>& p) { return Real(p[i][k]) - Real(p[0][k]); };
    return (1 - t) * from(m.start) + t * from(m.end);
  });
}

Vector velocity(PairKind kind, const Motion& m, Real u, Real v) {
  return gap_of(kind, u, v, [&](std::size_t i, std::size_t k) { return Real(m.end[i][k]) - Real(m.start[i][k]); });
}

class ContactNormal : public testing::TestWithParam<std::tuple<std::size_t, std::size_t>> {
 protected:
  template <class Check>
  void for_each_contact(double separation, const Check& check) {
    const Family& family = kFamilies[std::get<0>(GetParam())];
    const Placement& placement = kPlacements[std::get<1>(GetParam())];
    Random random(29);
    for (long i = 0; i < repetitions("TAMIS_NORMAL_CASES", 40) && !HasFailure(); ++i)
      for (const PairKind kind : kAllKinds) {
        const Motion m = permuted(kind, placed(family.make(kind, random), placement), random);
        const PairResult r = ask_pair(kind, m, {separation * placement.scale});
        if (!r.touches) continue;
        SCOPED_TRACE(describe(kind, m));
        const Vector normal{r.normal[0], r.normal[1], r.normal[2]};
        EXPECT_NEAR(double(length(normal)), 1, 1e-12);
        check(kind, m, r, normal);
      }
  }
};

// Bugs: the face's own side, an edge's order, the side after the contact, the sign of rounding.
TEST_P(ContactNormal, AtAFirstContactTheFeaturesMoveAgainstIt) {
  for (const double separation : {0.0, 0.125})
    for_each_contact(separation, [&](PairKind kind, const Motion& m, const PairResult& r, const Vector& normal) {
      if (r.toi_lower == 0) return;  // they may be near and part, or share more than one point
      const Vector speed = velocity(kind, m, r.u, r.v);
      // Where points of slivers lie rounding decides: to a part of the fastest corner.
      Real fastest = length(speed);
      for (const Real u : {0, 1})
        for (const Real v : {0, 1}) fastest = std::max(fastest, length(velocity(kind, m, u, v)));
      EXPECT_LE(double(dot(normal, speed)), 1e-6 * double(fastest)) << "separation " << separation;
    });
}

// Bugs: the time of another end of the bracket, another feature's direction, a gap that rounding has tilted.
TEST_P(ContactNormal, WithASeparationItLeadsAlongTheGapAtTheTimeOfImpact) {
  for (const double separation : {0x1p-40, 0x1p-20, 0.125})
    for_each_contact(separation, [&](PairKind kind, const Motion& m, const PairResult& r, const Vector& normal) {
      const Vector gap = gap_at(kind, m, r.toi_lower, r.u, r.v);
      const Real distance = length(gap), known = 0x1p-50L * size_of(kind, m);
      if (distance <= 64 * known) return;  // weights in doubles do not tell the direction
      Vector off;
      for (std::size_t k = 0; k < 3; ++k) off[k] = gap[k] / distance - normal[k];
      // What is proven; but of features that shrink to points or lines as they meet it is much less.
      const bool is_plain = kFamilies[std::get<0>(GetParam())].name == "random";
      EXPECT_LE(double(length(off)), (is_plain ? 1e-7 : 0x1p-9) + double(8 * known / distance)) << double(distance);
    });
}

INSTANTIATE_TEST_SUITE_P(Cases, ContactNormal,
                         testing::Combine(testing::Range(std::size_t{0}, kFamilies.size()),
                                          testing::Range(std::size_t{0}, kPlacements.size())),
                         case_name);

using Corners = std::array<Point, 4>;

void expect_normal(const PairResult& r, const Point& normal) {
  ASSERT_TRUE(r.touches);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(r.normal[k], normal[k], 1e-9) << k;
}

PairResult fall_on_face(double from, double to, bool is_turned, const PairOptions& options = {}) {
  Corners start{{{0.25, 0.25, from}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  if (is_turned) std::swap(start[2], start[3]);
  Corners end = start;
  end[0][2] = to;
  return vertex_face(start, end, options);
}

TEST(SideOfAFace, IsTheVertexsWhicheverWayTheFaceIsWound) {
  for (const bool is_turned : {false, true})
    for (const double separation : {0.0, 0.1}) {
      expect_normal(fall_on_face(1, -1, is_turned, {separation}), {0, 0, 1});
      expect_normal(fall_on_face(-1, 1, is_turned, {separation}), {0, 0, -1});
    }
}

TEST(SideOfAFace, IsTheOneItArrivesFromWhereItTouchesAtTheStart) {
  for (const bool is_turned : {false, true}) {
    expect_normal(fall_on_face(0, -1, is_turned), {0, 0, 1});
    expect_normal(fall_on_face(0, 1, is_turned), {0, 0, -1});
    expect_normal(fall_on_face(0, -1, is_turned, {0.1}), {0, 0, 1});
    expect_normal(fall_on_face(0.05, -1, is_turned, {0.1}), {0, 0, 1});
    expect_normal(fall_on_face(0.05, 1, is_turned, {0.1}), {0, 0, 1});  // where it is counts
    EXPECT_EQ(std::fabs(fall_on_face(0, 0, is_turned).normal[2]), 1) << "either side";
  }
}

/// The second edge rises from below to the first, touches it at t = 1/2 and goes down again. `up` -1: from above.
PairResult graze(double up, double separation) {
  const Corners start{{{-1, 0, 0}, {1, 0, 0}, {0, -0.5, -up}, {0, 1, up}}};
  const Corners end{{{-1, 0, 0}, {1, 0, 0}, {0, -1.5, up}, {0, 1, -up}}};
  return edge_edge(start, end, {separation});
}

// Bug: the slope of the coplanarity, which is zero, taken for a sign.
TEST(SideOfAnEdge, IsKnownWhereTheOtherOnlyGrazesIt) {
  expect_normal(graze(1, 0), {0, 0, 1});
  expect_normal(graze(-1, 0), {0, 0, -1});
  EXPECT_EQ(graze(1, 0).toi_lower, 0.5);
}

TEST(SideOfAnEdge, DoesNotDependOnTheEdgesDirections) {
  Corners start{{{-1, 0, 0}, {1, 0, 0}, {0, -1, 1}, {0, 1, 1}}}, end = start;
  end[2][2] = end[3][2] = -1;
  for (int turned = 0; turned < 4; ++turned) {
    for (auto* points : {&start, &end}) {
      std::swap((*points)[0], (*points)[1]);
      if (turned == 2) std::swap((*points)[2], (*points)[3]);
    }
    for (const double separation : {0.0, 0.25}) expect_normal(edge_edge(start, end, {separation}), {0, 0, -1});
  }
}

// Bug: no side where all stay in one plane, whose normal is no way out.
TEST(SideInAPlane, IsThatOfTheClosestPoints) {
  const Corners start{{{-2, 0.25, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  Corners end = start;
  end[0][0] = 0.375;
  expect_normal(vertex_face(start, end), {-1, 0, 0});
  end[0][0] = 0;  // at t = 1, exactly
  expect_normal(vertex_face(start, end), {-1, 0, 0});
}

TEST(SideOfAPoint, IsTheOneItArrivesFrom) {
  expect_normal(vertex_vertex({{{3, 4, 0}, {0, 0, 0}}}, {{{-3, -4, 0}, {0, 0, 0}}}), {0.6, 0.8, 0});
  expect_normal(vertex_edge({{{0.3, 1, 1}, {0, 0, 0}, {1, 0, 0}}}, {{{0.6, -1, -1}, {0, 0, 0}, {1, 0, 0}}}),
                {0, std::sqrt(0.5), std::sqrt(0.5)});
}

/// Straight motion as a path.
PairResult on_path(PairKind kind, const Motion& m, double separation) {
  const BezierPath path({{m.start.begin(), m.start.end()}, {m.end.begin(), m.end.end()}});
  const PairOptions options{.min_separation = separation};
  if (kind == PairKind::vertex_face) return vertex_face(path, {0, 1, 2, 3}, options);
  if (kind == PairKind::edge_edge) return edge_edge(path, {0, 1, 2, 3}, options);
  if (kind == PairKind::vertex_edge) return vertex_edge(path, {0, 1, 2}, options);
  return vertex_vertex(path, {0, 1}, options);
}

// Bug: another side, or another time, on a path.
TEST(SideOnAPath, IsThatOfStraightMotion) {
  Random random(31);
  for (int i = 0; i < 300; ++i)
    for (const PairKind kind : kAllKinds)
      for (const double separation : {0.0, 0.125}) {
        const Motion m = family_named("random").make(kind, random);
        const PairResult straight = ask_pair(kind, m, {separation});
        if (!straight.touches || straight.toi_lower == 0) continue;
        const PairResult curved = on_path(kind, m, separation);
        ASSERT_TRUE(curved.touches);
        SCOPED_TRACE(describe(kind, m));
        for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(curved.normal[k], straight.normal[k], 1e-5) << separation;
      }
}

}  // namespace
}  // namespace tamis::test
