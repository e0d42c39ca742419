// Whole meshes on paths: against all pairs one by one, and on motions whose answer is known.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "curves/paths/counted_path.hpp"
#include "curves/paths/turning_pairs.hpp"
#include "scenes/shapes.hpp"
#include "support/contact_sets.hpp"
#include "support/copied.hpp"
#include "support/yardstick/methods.hpp"
#include "tamis/detector.hpp"
#include "tamis/error.hpp"
#include "tamis/spline_path.hpp"

namespace tamis::test {
namespace {

using scenes::Shape;

/// Two closed bodies, or more, each a group of its own.
struct Bodies {
  std::vector<Point> rest;
  std::vector<Face> faces;
  std::vector<Index> body;

  void add(const Shape& shape, const Point& scale = {1, 1, 1}) {
    const auto first = static_cast<Index>(rest.size()), number = body.empty() ? 0 : body.back() + 1;
    for (const Point& p : shape.points) {
      rest.push_back({scale[0] * p[0], scale[1] * p[1], scale[2] * p[2]});
      body.push_back(number);
    }
    for (const Face& f : shape.faces) faces.push_back({first + f[0], first + f[1], first + f[2]});
  }
  Mesh mesh() const { return {static_cast<Index>(rest.size()), faces}; }
  yardstick::Options options() const {
    yardstick::Options options;
    options.filter = PairFilter::no_self_contact(body);
    return options;
  }
};

/// Every pair of the mesh by itself.
std::vector<Contact> one_by_one(const Mesh& mesh, const yardstick::Options& options, const Path& path) {
  std::vector<Contact> contacts;
  const auto ask = [&](PairKind kind, const std::array<Index, 4>& v, const PairResult& r) {
    if (r.touches) contacts.push_back({kind, r.certainty, v, r.toi_lower, r.toi_upper, r.u, r.v, r.normal});
  };
  const auto& group = options.filter.group_of_vertex;
  const auto apart = [&](Index a, Index b) {
    return group[static_cast<std::size_t>(a)] != group[static_cast<std::size_t>(b)];
  };
  const PairOptions rule{options.min_separation};
  for (const Index p : mesh.points())
    for (const Face& f : mesh.faces())
      if (apart(p, f[0])) {
        const std::array<Index, 4> v{p, f[0], f[1], f[2]};
        ask(PairKind::vertex_face, v, vertex_face(path, v, rule));
      }
  for (const Edge& a : mesh.edges())
    for (const Edge& b : mesh.edges())
      if (a < b && apart(a[0], b[0])) {
        const std::array<Index, 4> v{a[0], a[1], b[0], b[1]};
        ask(PairKind::edge_edge, v, edge_edge(path, v, rule));
      }
  return contacts;
}

void expect_as_one_by_one(const Bodies& bodies, const Path& path, double separation = 0) {
  yardstick::Options options = bodies.options();
  options.min_separation = separation;
  const std::vector<Contact> truth = one_by_one(bodies.mesh(), options, path);
  double first = 1;
  for (const Contact& c : truth) first = std::min(first, c.toi_lower);
  for (const int threads : {1, 3}) {
    options.threads = threads;
    Detector detector = yardstick::make_detector(bodies.mesh(), options);
    const std::vector<Contact> contacts = copied(detector.contacts(path));
    EXPECT_EQ(missing(names_of(truth), names_of(contacts)), "");
    EXPECT_EQ(missing(names_of(contacts), names_of(truth)), "");
    for (const Contact& c : contacts) {
      EXPECT_LE(c.toi_upper - c.toi_lower, 1e-9);
      const auto alone = std::find_if(truth.begin(), truth.end(), [&](const Contact& other) {
        return other.kind == c.kind && other.vertices == c.vertices;
      });
      if (alone == truth.end() || c.toi_lower == 0) continue;
      const Point &n = c.normal, &other = alone->normal;
      EXPECT_GE(n[0] * other[0] + n[1] * other[1] + n[2] * other[2], 1 - 1e-6) << "the same side and direction";
    }
    EXPECT_EQ(detector.is_free(path), truth.empty());
    const EarliestContact earliest = detector.earliest(path);
    EXPECT_EQ(earliest.contact.has_value(), !truth.empty());
    EXPECT_NEAR(earliest.toi_lower, first, 1e-9);
  }
}

/// One body beside the other, turning about a place between them.
RigidPath passing(const Bodies& bodies, double distance, double angle) {
  const RigidChain turning = turned_chain({{0, 0, 0}, {0.1, 0.2, 0.3}}, {0, 0, angle}, {0, 0, 0});
  const RigidChain passing =
      turned_chain({{distance, 0, 0}, {0, 0.3, 0}}, {0.2, -angle, 0.1}, {distance - 0.1, 0.5, 0});
  return {bodies.rest, bodies.body, {turning, passing}};
}

// Bugs: a radius that forgets the deviation of one vertex, a pair lost between two pieces, or reported by both.
TEST(MeshOnPath, TurningBodiesGiveTheContactsOfAllPairs) {
  Bodies bodies;
  bodies.add(scenes::unit_sphere(2), {1, 0.6, 0.8});
  bodies.add(scenes::unit_sphere(1), {0.5, 0.7, 1});
  for (const double distance : {1.1, 1.4, 1.75})
    for (const double angle : {0.02, 0.5, 3.0}) {
      SCOPED_TRACE(testing::Message() << distance << " apart, turned by " << angle);
      expect_as_one_by_one(bodies, passing(bodies, distance, angle));
    }
  expect_as_one_by_one(bodies, passing(bodies, 1.6, 0.7), 0.05);
}

// Bug: splines whose deviation is that of one piece only.
TEST(MeshOnPath, SplinesGiveTheContactsOfAllPairs) {
  Bodies bodies;
  bodies.add(scenes::unit_sphere(1));
  bodies.add(scenes::unit_sphere(1), {0.3, 0.4, 0.5});
  Random random(4);
  std::vector<std::vector<Point>> frames(4, bodies.rest);
  for (std::size_t i = 0; i < frames.size(); ++i)
    for (std::size_t v = 0; v < bodies.rest.size(); ++v) {
      const Point by = random.point_between(-0.1, 0.1);
      for (std::size_t k = 0; k < 3; ++k) frames[i][v][k] += by[k];
      if (bodies.body[v] == 1)
        frames[i][v][0] += 2.2 - 0.5 * static_cast<double>(i * i) + 0.4 * static_cast<double>(i * i * i) / 3;
    }
  expect_as_one_by_one(bodies, CatmullRomPath(frames));
  expect_as_one_by_one(bodies, BezierPath(frames));
}

// Bug, once: each vertex' deviation was added to its own radius, though an edge has the radius of its thick end where
// its thin end bends. That end comes down from 12 to 9 and goes up again, above another edge.
TEST(MeshOnPath, TheThinEndOfAThickEdgeBends) {
  const std::vector<Point> ends{{0, 0, 12}, {1000, 0, 12}, {0, -1, 0}, {0, 1, 0}};
  std::vector<Point> middle = ends;
  middle[0][2] = 6;
  const BezierPath path({ends, middle, ends});
  Options options;
  options.filter = {{0, 1, 0, 0}, 2};
  options.radii = {0, 10};
  Detector detector(Mesh(4, {}, {{0, 1}, {2, 3}}), options);
  EXPECT_FALSE(detector.is_free(path));
  const auto& contacts = detector.contacts(path);
  ASSERT_EQ(contacts.size(), 1u);
  EXPECT_NEAR(contacts[0].toi_lower, 0.5 - std::sqrt(1 / 12.0), 1e-8);
}

// The same on halves of a piece, which are looked at where more than a few pairs are left: in each half thin ends come
// down by 3 from 102 and go up again, above edges of their own.
TEST(MeshOnPath, TheThinEndsOfThickEdgesBendOnBothHalvesOfAPiece) {
  constexpr Index kPairs = 5;
  std::vector<std::vector<Point>> control(5);
  std::vector<Edge> rods;
  Options options;
  options.filter.group_count = 2;
  options.radii = {0, 100};
  for (Index i = 0; i < kPairs; ++i) {
    const double y = 1000.0 * i;
    for (std::size_t k = 0; k < control.size(); ++k) {
      const double z = 90 + std::array{12, 0, 28, 0, 12}[k];  // 102 - 192 t (1 - t) (t - 1/2)^2
      control[k].insert(control[k].end(), {{0, y, z}, {20000, y, 102}, {0, y - 1, 0}, {0, y + 1, 0}});
    }
    rods.push_back({4 * i, 4 * i + 1});
    rods.push_back({4 * i + 2, 4 * i + 3});
    options.filter.group_of_vertex.insert(options.filter.group_of_vertex.end(), {0, 1, 0, 0});
  }
  Detector detector(Mesh(4 * kPairs, {}, rods), options);
  EXPECT_EQ(detector.contacts(BezierPath(control)).size(), static_cast<std::size_t>(kPairs));
}

/// A ridge along a helix, from one radius to another, as a strip of triangles.
Shape helix(double inner, double outer, double phase, int turns) {
  constexpr int kAround = 24;
  Shape shape;
  for (int i = 0; i <= kAround * turns; ++i) {
    const double angle = 2 * kPi * i / kAround + phase, z = static_cast<double>(i) / kAround;
    for (const double r : {inner, outer}) shape.points.push_back({r * std::cos(angle), r * std::sin(angle), z});
    const auto p = static_cast<Index>(2 * i);
    if (i == 0) continue;
    shape.faces.push_back({p - 2, p - 1, p});
    shape.faces.push_back({p - 1, p + 1, p});
  }
  return shape;
}

// Bug: deviations of a turn so large that a bolt touches its nut, or a turn so coarse that it passes through it.
TEST(MeshOnPath, ABoltTurnsInItsThreadAndJamsWithoutThePitch) {
  Bodies bodies;
  bodies.add(helix(0.8, 1.05, 0, 2));
  bodies.add(helix(0.95, 1.2, kPi, 4));  // half a pitch away
  const auto screwed = [&](double turns, double way) {
    return RigidPath(bodies.rest, bodies.body, {turned_chain({}, {0, 0, 2 * kPi * turns}, {0, 0, way}), RigidChain{}});
  };
  Detector detector = yardstick::make_detector(bodies.mesh(), bodies.options());
  EXPECT_TRUE(detector.is_free(screwed(1.5, 1.5)));
  const EarliestContact jammed = detector.earliest(screwed(1.5, 0));
  ASSERT_TRUE(jammed.contact);
  // The ridges are half a pitch apart: half a turn, but for the corners of the strips.
  EXPECT_NEAR(jammed.toi_lower, 1.0 / 3, 0.02);
  EXPECT_LE(jammed.toi_upper - jammed.toi_lower, 1e-9);
  EXPECT_FALSE(detector.is_free(screwed(1.5, 0.75)));
}

// Bug: links composed in the other order; a chain taken for its last link.
TEST(MeshOnPath, AnArmOfTwoLinksReachesWhereItShould) {
  Bodies bodies;
  bodies.add(scenes::unit_sphere(1), {0.1, 0.1, 0.1});
  bodies.add(scenes::unit_sphere(2), {0.3, 0.3, 0.3});
  // Shoulder turns by 90 degrees, elbow straightens: the hand goes from (0, 0, 0) to (0, 2, 0).
  const RigidChain shoulder = turned_chain({}, {0, 0, kPi / 2}, {0, 0, 0}),
                   elbow = turned_chain({{1, 0, 0}, {0, 0, kPi}}, {0, 0, -kPi}, {1, 0, 0});
  RigidChain arm = shoulder;
  arm.insert(arm.end(), elbow.begin(), elbow.end());
  arm.push_back({{{1, 0, 0}, {0, 0, 0}}, {{1, 0, 0}, {0, 0, 0}}});
  const auto with_ball_at = [&](const Point& place) {
    return RigidPath(bodies.rest, bodies.body, {arm, RigidChain{{{place, {0, 0, 0}}, {place, {0, 0, 0}}}}});
  };
  Detector detector = yardstick::make_detector(bodies.mesh(), bodies.options());
  const EarliestContact hit = detector.earliest(with_ball_at({0, 2.2, 0}));
  ASSERT_TRUE(hit.contact);
  EXPECT_GT(hit.toi_lower, 0.5);
  EXPECT_TRUE(detector.is_free(with_ball_at({0, -2, 0})));
  expect_as_one_by_one(bodies, with_ball_at({0.4, 1.2, 0}));
}

/// Claims to go straight, but does not.
struct LyingPath final : Path {
  explicit LyingPath(std::vector<Point> points) : rest(std::move(points)) {}
  Index vertex_count() const override { return static_cast<Index>(rest.size()); }
  void points_at(double time, std::span<const Index> vertices, std::span<Point> points,
                 std::span<double> errors) const override {
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      points[i] = rest[static_cast<std::size_t>(vertices[i])];
      points[i][2] += time * time;
      errors[i] = 1e-15;
    }
  }
  void deviations(double, double, std::span<const Index> vertices, std::span<double> deviations) const override {
    for (std::size_t i = 0; i < vertices.size(); ++i) deviations[i] = 0;
  }
  std::vector<Point> rest;
};

/// A point that falls through a triangle in the first of two pieces at least, and on below it in the others.
struct FallThrough final : Path {
  Index vertex_count() const override { return 4; }
  void points_at(double time, std::span<const Index> vertices, std::span<Point> points,
                 std::span<double> errors) const override {
    const std::array<Point, 4> all{Point{0.2, 0.2, 0.25 - time}, Point{0, 0, 0}, Point{1, 0, 0}, Point{0, 1, 0}};
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      points[i] = all[static_cast<std::size_t>(vertices[i])];
      errors[i] = 0;
    }
  }
  void deviations(double from, double to, std::span<const Index> vertices,
                  std::span<double> deviations) const override {
    for (std::size_t i = 0; i < vertices.size(); ++i) deviations[i] = to - from > 0.6 ? 1 : 0;
  }
};

// Bug: what a question cost is what its last piece cost, here nothing.
TEST(MeshOnPath, StatisticsAreOfAllPieces) {
  Detector detector(Mesh(4, {{1, 2, 3}}, {}, {0}));
  ASSERT_EQ(detector.contacts(FallThrough()).size(), 1U);
  const Statistics& cost = detector.statistics();
  EXPECT_EQ(cost.stages.front().vf, 1U);
  EXPECT_GT(cost.nodes_visited, 0U);
}

// Bug: pieces were as short where nothing is near as a nut on its bolt needs them.
TEST(MeshOnPath, PiecesAreFewWhereNothingIsNear) {
  Bodies bodies;
  bodies.add(scenes::unit_sphere(24));
  bodies.add(scenes::unit_sphere(24));
  Options options;
  options.filter = bodies.options().filter;
  Detector detector(bodies.mesh(), options);
  const auto times_asked = [&](double gap) {
    const RigidPath path(
        bodies.rest, bodies.body,
        {turned_chain({}, {0, 0, 0.5}, {}), interpolated_chain({{2 + gap, 0, 0}, {}}, {{2 + gap, 0, 0}, {}})});
    const CountedPath counted(path);
    EXPECT_FALSE(detector.earliest(counted).contact);
    return counted.asked;
  };
  const int far = times_asked(1);  // of each piece its end and its middle
  EXPECT_LE(far, 9);
  EXPECT_EQ(times_asked(1), far);
  EXPECT_LE(times_asked(0.02), 12);
}

TEST(MeshOnPath, BadPathsAreNamed) {
  Bodies bodies;
  bodies.add(scenes::unit_sphere(1));
  Detector detector = yardstick::make_detector(bodies.mesh(), bodies.options());
  const RigidPath fewer({{0, 0, 0}}, {0}, {RigidChain{}});
  EXPECT_THROW((void)detector.contacts(fewer), InvalidPath);
  const RigidPath still(bodies.rest, bodies.body, {RigidChain{}});
  EXPECT_TRUE(detector.is_free(still));
  for (const double tolerance : {0.0, -1.0, 1.5, std::nan("")})
    EXPECT_THROW((void)detector.earliest(still, {.tolerance = tolerance}), InvalidOptions);
  EXPECT_THROW((void)detector.is_free(still, {.min_separation = -1.0}), InvalidOptions);
  EXPECT_THROW((void)detector.contacts(LyingPath(bodies.rest)), InvalidPath);
}

}  // namespace
}  // namespace tamis::test
