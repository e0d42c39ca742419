// The straight ways that stand for curves on a piece: no vertex is farther from its own than is said.
#include "curves/paths/mesh_pieces.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "scenes/shapes.hpp"
#include "tamis/rigid_path.hpp"

namespace tamis::test {
namespace {

const Mesh kTriangle(3, {{0, 1, 2}});
const std::vector<Point> kRest{{1, 0, 0}, {0, 3, 1}, {0, 0, 0.5}};

/// The largest distance of a vertex from its way, in parts of what is said to be the largest.
double farthest_share(const Path& path, double from, double to, const ShiftedChords& lines) {
  std::vector<Index> all(kRest.size());
  std::iota(all.begin(), all.end(), 0);
  std::vector<Point> points(all.size());
  std::vector<double> errors(all.size());
  double farthest = 0;
  for (int i = 0; i <= 64; ++i) {
    const double share = i / 64.0;
    path.points_at(from + share * (to - from), all, points, errors);
    for (std::size_t v = 0; v < points.size(); ++v) {
      double square = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const double off = points[v][k] - ((1 - share) * lines.start[v][k] + share * lines.end[v][k]);
        square += off * off;
      }
      farthest = std::max(farthest, std::sqrt(square) / (lines.deviations[v] + 1e-14));
    }
  }
  return farthest;
}

TEST(MeshPieces, CurvesStayBesideTheirLines) {
  for (const Point& turn : {Point{0, 0, 0.5}, Point{3, -4, 1}, Point{40, 0, 0}}) {
    const RigidPath path(kRest, {0, 0, 0}, {turned_chain({{1, 2, 3}, {0.1, 0, 0}}, turn, {2, 2, 2})});
    const std::vector<double> ends{0.25, 0.3, 1};
    MeshPieces pieces(kTriangle, path, ends, 0);
    for (MeshMoment from = pieces.moment_at(0); from.time < 1;) {
      const MeshMoment to = pieces.next(from);
      EXPECT_LE(farthest_share(path, from.time, to.time, pieces.chords()), 1) << "from " << from.time;
      from = to;
    }
  }
}

/// Of a turn by little the bound is nearly what the curve strays from its chord; beside that it is three fourths.
TEST(MeshPieces, LinesBesideChordsAreNearer) {
  const RigidPath path(kRest, {0, 0, 0}, {turned_chain({}, {0, 0, 0.1}, {})});
  const std::vector<double> ends{1};
  MeshPieces pieces(kTriangle, path, ends, 0);
  pieces.next(pieces.moment_at(0));
  std::vector<double> chords(3);
  path.deviations(0, 1, std::vector<Index>{0, 1, 2}, chords);
  for (std::size_t v = 0; v < 2; ++v) EXPECT_LT(pieces.chords().deviations[v], (kShiftedChordPart + 1e-6) * chords[v]);
}

int count_pieces(const Mesh& mesh, const Path& path, double separation = 0) {
  MeshPieces pieces(mesh, path, {}, separation);
  int count = 0;
  for (MeshMoment from = pieces.moment_at(0); from.time < 1; ++count) from = pieces.next(from);
  return count;
}

/// A tetrahedron that turns, and `grounds` wide triangles that stay.
int pieces_of_a_turn(Index grounds) {
  std::vector<Face> faces{{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}};
  std::vector<Point> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  std::vector<Index> bodies{0, 0, 0, 0};
  for (Index i = 0; i < grounds; ++i) {
    const auto first = static_cast<Index>(points.size());
    faces.push_back({first, first + 1, first + 2});
    const double x = 1e4 * i;
    points.insert(points.end(), {{x, 0, -2}, {x + 1e4, 0, -2}, {x, 1e4, -2}});
    bodies.insert(bodies.end(), 3, 1);
  }
  const Mesh mesh(static_cast<Index>(points.size()), faces);
  return count_pieces(mesh, RigidPath(points, bodies, {turned_chain({}, {0, 0, 3}, {}), {}}));
}

TEST(MeshPieces, AreAsLongAboveWideTrianglesAsAlone) {
  EXPECT_GT(pieces_of_a_turn(0), 4);
  EXPECT_EQ(pieces_of_a_turn(12), pieces_of_a_turn(0));
}

// Bug: a speck that turned within a separation a million times its size made thousands of pieces.
TEST(MeshPieces, AreAsLongAsASeparationAllows) {
  const auto pieces_of_a_triangle = [](double edge, double separation) {
    const std::vector<Point> points{{1, 0, 0}, {1 + edge, 0, 0}, {1, edge, 0}};
    return count_pieces(kTriangle, RigidPath(points, {0, 0, 0}, {turned_chain({}, {0, 0, 3}, {})}), separation);
  };
  EXPECT_GT(pieces_of_a_triangle(1e-6, 0), 1000);
  EXPECT_LE(pieces_of_a_triangle(1e-6, 0.5), pieces_of_a_triangle(0.5, 0));
}

// Bug: one vertex 10^10 edges from an axis of rotation made 27 thousand pieces, in each of which the whole mesh is
// asked.
TEST(MeshPieces, AreNotShorterForAFewVerticesFarAway) {
  scenes::Scene scene;
  scenes::add_grid_faces(scene, 0, 10, 10);
  std::vector<Point> points;
  for (int i = 0; i < 100; ++i) points.push_back({0.1 * (i % 10), 0.1 * (i / 10), 0});
  const auto pieces_with = [&](const Point& last) {
    points.push_back(last);
    const Mesh mesh(101, scene.faces, {}, {100});
    const int count =
        count_pieces(mesh, RigidPath(points, std::vector<Index>(101, 0), {turned_chain({}, {0, 0, 1}, {})}));
    points.pop_back();
    return count;
  };
  EXPECT_EQ(pieces_with({1e9, 0, 1}), pieces_with({0.5, 0, 1}));
}

}  // namespace
}  // namespace tamis::test
