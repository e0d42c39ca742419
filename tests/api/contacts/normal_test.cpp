// The normal of a contact is a unit vector, however small or degenerate the features are. Every method and every call
// returns the same one. With a separation it points along the closest points, which a search over all candidates finds.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "support/contact_sets.hpp"
#include "support/test_names.hpp"
#include "support/yardstick/methods.hpp"
#include "tamis/detector.hpp"
#include "tamis/pair.hpp"

namespace tamis::test {
namespace {

using scenes::Scene;

/// An edge of twice the given length falls on another, crosswise, from height 1 to -1.
Scene crossing_edges(double length) {
  Scene scene;
  const auto add = [&](const Point& from, double fall) {
    return scene.add_vertex(from, {from[0], from[1], from[2] - fall}, 0);
  };
  const Index a = add({-length, 0, 0}, 0), b = add({length, 0, 0}, 0);
  const Index c = add({0, -length, 1}, 2), d = add({0, length, 1}, 2);
  scene.loose_edges = {{a, b}, {c, d}};
  return scene;
}

/// A point falls on a face of the given size, from height 1 to -1.
Scene point_on_face(double size) {
  Scene scene;
  for (const Point& p : {Point{-size, -size, 0}, Point{size, -size, 0}, Point{0, size, 0}}) scene.add_vertex(p, p, 0);
  scene.faces.push_back({0, 1, 2});
  scene.loose_points.push_back(scene.add_vertex({0, 0, 1}, {0, 0, -1}, 0));
  return scene;
}

class Normal : public testing::TestWithParam<Method> {};

// Bug: a square underflows, and the length it is divided by is zero.
TEST_P(Normal, IsAUnitVectorHoweverSmallTheFeatures) {
  yardstick::Options options;
  options.method = GetParam();
  for (const double size : {1.0, 1e-60, 1e-90, 1e-120, 1e-170, 1e-300})
    for (const Scene& scene : {crossing_edges(size), point_on_face(size)}) {
      const auto contacts = find_contacts(scene, options);
      ASSERT_EQ(contacts.size(), 1u) << size;
      EXPECT_NEAR(std::fabs(contacts[0].normal[2]), 1, 1e-12) << size;
    }
}

TEST_P(Normal, IsAUnitVectorWhereAFeatureIsAPoint) {
  yardstick::Options options;
  options.method = GetParam();
  Scene scene = crossing_edges(5e-324);
  scene.start[2] = scene.start[3];
  scene.end[2] = scene.end[3];
  scene.start[0] = scene.end[0] = scene.start[1] = scene.end[1] = {0, 5e-324, 0};
  const auto contacts = find_contacts(scene, options);
  ASSERT_EQ(contacts.size(), 1u);
  EXPECT_NEAR(std::hypot(contacts[0].normal[0], contacts[0].normal[1], contacts[0].normal[2]), 1, 1e-12);
}

/// Decides the contact's pair as a list of one pair.
PairResult alone(const Scene& scene, const Contact& c, double separation) {
  PairOptions options;
  options.min_separation = separation;
  return narrow_phase(std::vector<FeaturePair>{{c.kind, c.vertices}}, scene.step(), options)[0];
}

// Bugs: in lanes, the normal points to another side than for single pairs, exact decisions, or the paper's solver.
TEST_P(Normal, IsTheSameInEveryMethodAndForThePairAlone) {
  yardstick::Options options;
  options.method = GetParam();
  for (const scenes::Recipe& recipe : scenes::recipes())
    for (const double separation : {0.0, 0x1p-7}) {
      const Scene scene = recipe.make(80, 3);
      options.min_separation = separation;
      for (const Contact& c : find_contacts(scene, options)) {
        const PairResult r = alone(scene, c, separation);
        ASSERT_TRUE(r.touches);
        if (separation > 0) {
          ASSERT_EQ(c.normal, r.normal) << scene.name;
        } else {
          const double along = c.normal[0] * r.normal[0] + c.normal[1] * r.normal[1] + c.normal[2] * r.normal[2];
          ASSERT_GE(along, 1 - 1e-6) << scene.name << ", " << name_of(c.kind) << " at " << c.toi_lower;
        }
      }
    }
}

INSTANTIATE_TEST_SUITE_P(Methods, Normal, testing::ValuesIn(kMethods),
                         [](const testing::TestParamInfo<Method>& method) { return test_name(name_of(method.param)); });

using Vector = std::array<long double, 3>;

long double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector mixed(long double a, const Vector& x, long double b, const Vector& y) {
  return {a * x[0] + b * y[0], a * x[1] + b * y[1], a * x[2] + b * y[2]};
}
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The shortest vector from a point of the second feature to one of the first, and the parts of the features in which
/// its ends lie.
struct Shortest {
  Vector gap{};
  std::string parts;
  void offer(const Vector& other, const char* which) {
    if (!parts.empty() && dot(other, other) >= dot(gap, gap)) return;
    gap = other;
    parts = which;
  }
};

void offer_point_on_line(const Vector& p, const Vector& a, const Vector& b, int sign, Shortest& shortest) {
  const Vector side = mixed(1, b, -1, a), from = mixed(1, p, -1, a);
  const long double s = dot(from, side) / dot(side, side);
  if (s > 0 && s < 1) shortest.offer(mixed(sign, from, -sign * s, side), "vertex-edge");
}

Shortest shortest_of(PairKind kind, const std::array<Vector, 4>& x) {
  Shortest shortest;
  const std::size_t second = kind == PairKind::edge_edge ? 2 : 1;
  for (std::size_t i = 0; i < second; ++i)
    for (std::size_t j = second; j < 4; ++j) shortest.offer(mixed(1, x[i], -1, x[j]), "vertex-vertex");
  if (kind == PairKind::edge_edge) {
    for (std::size_t i = 0; i < 2; ++i) offer_point_on_line(x[i], x[2], x[3], 1, shortest);
    for (std::size_t i = 2; i < 4; ++i) offer_point_on_line(x[i], x[0], x[1], -1, shortest);
  } else {
    for (std::size_t i = 1; i < 4; ++i) offer_point_on_line(x[0], x[i], x[i % 3 + 1], 1, shortest);
  }
  // The common perpendicular, if both its feet lie inside the features.
  const Vector e = kind == PairKind::edge_edge ? mixed(1, x[1], -1, x[0]) : mixed(1, x[2], -1, x[1]);
  const Vector f = kind == PairKind::edge_edge ? mixed(1, x[3], -1, x[2]) : mixed(1, x[3], -1, x[1]);
  const Vector n = cross(e, f), d = kind == PairKind::edge_edge ? mixed(1, x[2], -1, x[0]) : mixed(1, x[0], -1, x[1]);
  const long double nn = dot(n, n), u = dot(cross(d, f), n) / nn;
  const long double v = (kind == PairKind::edge_edge ? dot(cross(d, e), n) : dot(cross(e, d), n)) / nn;
  const bool is_inside = u > 0 && v > 0 && (kind == PairKind::edge_edge ? u < 1 && v < 1 : u + v < 1);
  const long double height = (kind == PairKind::edge_edge ? -1 : 1) * dot(d, n) / nn;
  if (is_inside) shortest.offer(mixed(height, n, 0, n), "inside");
  return shortest;
}

// Bug, once in this library: a vertex at the border of a face got the face's normal, which is 30 degrees off or more
// for 7 to 29 of 100 contacts of thick cloth; and the side depended on the face's winding.
TEST(NormalOfThickCloth, LeadsAlongTheClosestPointsAtTheTimeOfImpact) {
  std::map<std::string, int> counts;
  for (const double radii : {0.05, 0.2}) {  // in edge lengths
    const Scene scene = scenes::scene_by_name("folded-cloth", 3000, 5);
    yardstick::Options options;
    options.min_separation = radii / 40;
    for (const Contact& c : find_contacts(scene, options)) {
      std::array<Vector, 4> x;
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t k = 0; k < 3; ++k) {
          const auto v = static_cast<std::size_t>(c.vertices[i]);
          x[i][k] = (1 - static_cast<long double>(c.toi_lower)) * scene.start[v][k] +
                    static_cast<long double>(c.toi_lower) * scene.end[v][k];
        }
      const Shortest shortest = shortest_of(c.kind, x);
      ++counts[shortest.parts];
      const long double length = std::sqrt(dot(shortest.gap, shortest.gap));
      const Vector off = mixed(1 / length, shortest.gap, -1, {c.normal[0], c.normal[1], c.normal[2]});
      ASSERT_LE(std::sqrt(dot(off, off)), 1e-9L) << shortest.parts << ", " << name_of(c.kind) << " at " << c.toi_lower;
    }
  }
  for (const char* parts : {"vertex-vertex", "vertex-edge", "inside"}) EXPECT_GT(counts[parts], 100) << parts;
}

}  // namespace
}  // namespace tamis::test
