#include "files/mesh/triangulation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "tamis/detector.hpp"

namespace tamis::io {
namespace {

using Corners = std::vector<Point>;

struct Cut {
  std::vector<Face> faces;
  PolygonDoubts doubts;
};

Cut cut_of(const Corners& corners) {
  std::vector<Index> indices(corners.size());
  std::iota(indices.begin(), indices.end(), 0);
  Cut cut;
  cut.doubts = Triangulation().cut(indices, corners, cut.faces);
  return cut;
}

/// Twice the area of a polygon or triangle in the plane z = 0.
double area(const Corners& corners) {
  double sum = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point &a = corners[i], &b = corners[(i + 1) % corners.size()];
    sum += a[0] * b[1] - a[1] * b[0];
  }
  return sum;
}

/// Triangles stay inside just if they have the winding and the area of the polygon, and nothing touches anything else.
void expect_inside(const Corners& corners, const Cut& cut) {
  EXPECT_FALSE(cut.doubts.is_tangled);
  ASSERT_EQ(cut.faces.size(), corners.size() - 2);
  const double whole = area(corners);
  double sum = 0;
  for (const Face& f : cut.faces) {
    const auto at = [&](Index v) { return corners[static_cast<std::size_t>(v)]; };
    const double part = area({at(f[0]), at(f[1]), at(f[2])});
    EXPECT_GT(part * whole, 0);
    sum += part;
  }
  EXPECT_NEAR(sum / whole, 1, 1e-9);
}

std::size_t intersections_of(const Corners& corners, const Cut& cut) {
  Detector detector(Mesh(static_cast<Index>(corners.size()), cut.faces));
  return detector.intersections(corners).size();
}

/// The same polygon elsewhere: axes exchanged and scaled, so that flat polygons stay flat in every double.
Corners placed(const Corners& corners, std::size_t turn, double scale) {
  Corners other;
  for (const Point& p : corners) {
    Point q;
    for (std::size_t axis = 0; axis < 3; ++axis) q[(axis + turn) % 3] = scale * p[axis];
    other.push_back(q);
  }
  return other;
}

Corners star(std::mt19937& random, std::size_t corners) {
  std::uniform_real_distribution<double> radius(0.05, 1);
  Corners star;
  for (std::size_t i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(corners),
                 r = radius(random);
    star.push_back({r * std::cos(angle), r * std::sin(angle), 0});
  }
  return star;
}

/// Teeth with corners on straight lines between them, as grids have.
Corners comb(int teeth) {
  Corners comb{{0, 0, 0}};
  for (int i = 0; i < 2 * teeth; ++i) comb.push_back({i + 1.0, 0, 0});
  for (int i = 2 * teeth; i > 0; --i) {
    comb.push_back({static_cast<double>(i), i % 2 ? 1.0 : 9.0, 0});
    comb.push_back({static_cast<double>(i) - 0.5, i % 2 ? 1.0 : 9.0, 0});
  }
  return comb;
}

// Bug: a triangle leaves a concave polygon, or a corner lies on a side of another triangle, so the polygon touches
// itself.
TEST(Triangulation, StaysInsideOfEverySimplePolygon) {
  std::mt19937 random(1);
  std::vector<Corners> polygons{{{2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}, {0, 0, 0}},
                                {{-1, -1, 0}, {0.5, 0, 0}, {-1, 1, 0}, {2, 0, 0}},
                                {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}},
                                comb(2),
                                comb(40)};
  for (std::size_t corners = 4; corners < 60; ++corners) polygons.push_back(star(random, corners));
  for (Corners polygon : polygons)
    for (std::size_t way = 0; way < 2 * polygon.size(); ++way) {
      expect_inside(polygon, cut_of(polygon));
      for (std::size_t turn = 0; turn < 3; ++turn) {
        const Corners other = placed(polygon, turn, way % 2 ? 0x1p-1000 : 0x1p900);
        ASSERT_EQ(intersections_of(other, cut_of(other)), 0u) << "polygon of " << polygon.size() << ", way " << way;
      }
      std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
      if (way == polygon.size()) std::reverse(polygon.begin(), polygon.end());
      if (polygon.size() > 30) way += 7;
    }
}

// Bug: points that doubles cannot tell from a line are taken for the wrong side of it.
TEST(Triangulation, DecidesExactly) {
  std::mt19937 random(2);
  std::uniform_int_distribution<int> step(-3, 3);
  for (int run = 0; run < 2000; ++run) {
    // A dart whose inner corner is a few bits from the line through its neighbours.
    constexpr double kUlp = 0x1p-53;
    Corners dart{{0.5, 0.5, 0}, {12, 12, 0}, {24, 24, 0}, {12, 30, 0}};
    dart[0][0] += step(random) * kUlp;
    dart[0][1] += step(random) * kUlp;
    const Cut cut = cut_of(dart);
    if (cut.doubts.is_tangled) continue;
    ASSERT_EQ(intersections_of(dart, cut), 0u) << run;
  }
}

// Bug: convex polygons are cut otherwise than before, so answers on known files change.
TEST(Triangulation, ConvexPolygonsGiveTheFan) {
  for (std::size_t n = 4; n < 40; ++n) {
    Corners circle;
    for (std::size_t i = 0; i < n; ++i) {
      const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
      circle.push_back({std::cos(angle), std::sin(angle), 0.1 * std::cos(angle)});
    }
    std::vector<Face> fan;
    for (Index i = 2; i < static_cast<Index>(n); ++i) fan.push_back({0, i - 1, i});
    EXPECT_EQ(cut_of(circle).faces, fan);
  }
}

// Bug: a hole that a bridge joins to the outline is filled.
TEST(Triangulation, BridgesLeadAroundHoles) {
  const Corners ring{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}};
  const std::vector<Index> once{0, 1, 2, 3, 0, 4, 5, 6, 7, 4};
  std::vector<Face> faces;
  EXPECT_FALSE(Triangulation().cut(once, ring, faces).is_tangled);
  ASSERT_EQ(faces.size(), 8u);
  double sum = 0;
  for (const Face& f : faces) {
    const auto at = [&](Index v) { return ring[static_cast<std::size_t>(v)]; };
    sum += area({at(f[0]), at(f[1]), at(f[2])});
  }
  EXPECT_EQ(sum, 24);
  Detector detector(Mesh(8, faces));
  EXPECT_TRUE(detector.intersections(ring).empty());
}

// Bug: polygons without a triangulation are cut without a word, or never end.
TEST(Triangulation, SaysWhatIsTangledOrBent) {
  const Corners bow{{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 1, 0}}, line{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}},
      point(5, {1, 2, 3}), bent{{0, 0, 0}, {1, 0, 0}, {1, 1, 0.1}, {0, 1, 0}};
  Corners pentagram;
  for (int i = 0; i < 5; ++i)
    pentagram.push_back({std::cos(i * 0.8 * std::numbers::pi), std::sin(i * 0.8 * std::numbers::pi), 0});
  for (const Corners& tangled : {bow, line, point, pentagram}) {
    const Cut cut = cut_of(tangled);
    EXPECT_TRUE(cut.doubts.is_tangled);
    EXPECT_EQ(cut.faces.size(), tangled.size() - 2);
  }
  EXPECT_TRUE(cut_of(bent).doubts.is_bent);
  EXPECT_FALSE(cut_of(bent).doubts.is_tangled);
  const Corners unknown{{0, 0, 0}, {1, 0, 0}, {std::nan(""), 1, 0}, {0, 1, 0}};
  EXPECT_EQ(cut_of(unknown).faces.size(), 2u);
}

// Bug: a corner listed twice makes a triangle without area.
TEST(Triangulation, ACornerListedTwiceCountsOnce) {
  const Corners square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  std::vector<Face> faces;
  Triangulation().cut(std::vector<Index>{0, 0, 1, 2, 2, 3, 0}, square, faces);
  EXPECT_EQ(faces, (std::vector<Face>{{0, 1, 2}, {0, 2, 3}}));
}

// Bug: a large polygon takes time that grows with the cube of its corners.
TEST(Triangulation, LargePolygonsTakeMoments) {
  std::mt19937 random(3);
  const Corners large = star(random, 20'000);
  expect_inside(large, cut_of(large));
}

}  // namespace
}  // namespace tamis::io
