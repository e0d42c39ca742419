#include "worlds/random_world.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace tamis::test {
namespace {

Shape scaled(const Mesh& mesh, std::vector<Point> points, double scale) {
  for (Point& p : points)
    for (double& x : p) x *= scale;
  return {mesh, std::move(points)};
}
Shape shape_of(const scenes::Shape& shape, double scale) {
  return scaled(Mesh(static_cast<Index>(shape.points.size()), shape.faces), shape.points, scale);
}

Shape sheet(Index cells) {
  scenes::Scene scene;
  scenes::add_grid_faces(scene, 0, cells + 1, cells + 1);
  std::vector<Point> points;
  for (Index i = 0; i <= cells; ++i)
    for (Index j = 0; j <= cells; ++j)
      points.push_back({2.0 * i / cells - 1, 2.0 * j / cells - 1, 0.05 * ((i + j) % 2)});
  return {Mesh(static_cast<Index>(points.size()), scene.faces), points};
}

/// No triangle: three edges, and two points.
Shape rod() {
  const std::vector<Point> points{{-1, 0, 0}, {0, 0.2, 0}, {1, 0, 0}, {0, 1, 0.1}, {0.1, -1, 0}};
  return {Mesh(5, {}, {{0, 1}, {1, 2}}, {3, 4}), points};
}

Pose random_pose(Random& random, double size, double turn) { return {random.point(size), random.point(turn)}; }

Point plus(const Point& a, double factor, const Point& b) {
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}

BodyMotion made_hard(BodyMotion motion, const Extremes& extremes) {
  const auto move = [&](Point& position) { position = plus(position, 1, extremes.away); };
  if (auto* still = std::get_if<Static>(&motion)) move(still->pose.position);
  if (auto* rigid = std::get_if<Rigid>(&motion)) {
    for (RigidLink& link : rigid->chain) {
      const Point turn = plus(link.end.rotation, -1, link.start.rotation);
      link.end.rotation = plus(link.end.rotation, extremes.turns - 1, turn);
    }
    move(rigid->chain.front().start.position);
    move(rigid->chain.front().end.position);
  }
  if (auto* soft = std::get_if<Deforming>(&motion))
    for (auto* points : {&soft->start, &soft->end})
      for (Point& point : *points) move(point);
  return motion;
}

}  // namespace

BodyMotion random_motion(Random& random, const Shape& shape, double size, Motions motions) {
  const Pose start = random_pose(random, size, 2);
  const int way = random.below(motions == Motions::any ? 6 : 3);
  if (way == 0) return Static{start};
  Pose end = start;
  for (std::size_t k = 0; k < 3; ++k) end.position[k] += random.in(-0.5, 0.5) * size;
  if (way == 1) return Rigid{interpolated_chain(start, end)};
  if (way == 2) {
    const Point shift = random.point(size);
    Deforming soft;
    for (const Point& p : shape.points()) {
      soft.start.push_back({p[0] + shift[0], p[1] + shift[1], p[2] + shift[2]});
      const Point off = random.point(0.3), &at = soft.start.back();
      soft.end.push_back({at[0] + off[0], at[1] + off[1], at[2] + off[2]});
    }
    return soft;
  }
  const Point turn = random.point(way == 3 ? 0.2 : 1.5);
  if (way == 5) return Rigid{turned_chain(start, turn, end.position)};
  for (std::size_t k = 0; k < 3; ++k) end.rotation[k] += turn[k];
  return Rigid{interpolated_chain(start, end)};
}

TestWorld random_world(std::uint64_t seed, double size, Motions motions, const Options& options,
                       const Extremes& extremes) {
  Random random(seed);
  const std::vector<Shape> shapes{shape_of(scenes::unit_sphere(3), 0.7), shape_of(scenes::unit_cube(2), 0.5), sheet(6),
                                  rod()};
  TestWorld made(options);
  for (int body = 0; body < 7; ++body) {
    Shape shape = shapes[static_cast<std::size_t>(random.below(4))];
    if (body % 2) shape = scaled(shape.mesh(), shape.points(), extremes.every_other);
    made.add(shape, made_hard(random_motion(random, shape, size, motions), extremes));
  }
  return made;
}

namespace {

struct Parts {
  std::vector<Point> start, end, rest, rest_end;
  std::vector<std::array<Index, 2>> names;
  std::vector<Index> body_of_vertex;
  std::vector<RigidChain> chains;
  std::vector<Face> faces;
  std::vector<Edge> edges;
  std::vector<Index> points;
};

RigidChain chain_of(const BodyMotion& motion) {
  if (const auto* still = std::get_if<Static>(&motion)) return interpolated_chain(still->pose, still->pose);
  return std::get<Rigid>(motion).chain;
}

bool turns(const BodyMotion& motion) {
  const auto* rigid = std::get_if<Rigid>(&motion);
  return rigid &&
         std::ranges::any_of(rigid->chain, [](const RigidLink& l) { return l.start.rotation != l.end.rotation; });
}

/// The vertices of a body at one time, in doubles.
std::vector<Point> points_at(const Shape& shape, const BodyMotion& motion, double time) {
  if (const auto* soft = std::get_if<Deforming>(&motion)) return time == 0 ? soft->start : soft->end;
  const std::size_t count = shape.points().size();
  const RigidPath path(shape.points(), std::vector<Index>(count, 0), {chain_of(motion)});
  std::vector<Index> all;
  for (std::size_t v = 0; v < count; ++v) all.push_back(static_cast<Index>(v));
  std::vector<Point> points(count);
  std::vector<double> errors(count);
  path.points_at(time, all, points, errors);
  return points;
}

void add(Parts& all, BodyId id, const Shape& shape, const BodyMotion& motion) {
  const auto first = static_cast<Index>(all.start.size());
  const std::vector<Point> start = points_at(shape, motion, 0), end = points_at(shape, motion, 1);
  all.chains.push_back(turns(motion) ? chain_of(motion) : RigidChain());
  for (std::size_t v = 0; v < start.size(); ++v) {
    all.names.push_back({id, static_cast<Index>(v)});
    all.body_of_vertex.push_back(static_cast<Index>(all.chains.size()) - 1);
    all.start.push_back(start[v]);
    all.end.push_back(end[v]);
    all.rest.push_back(turns(motion) ? shape.points()[v] : start[v]);
    all.rest_end.push_back(turns(motion) ? shape.points()[v] : end[v]);
  }
  const Mesh& mesh = shape.mesh();
  for (const Face& f : mesh.faces()) all.faces.push_back({first + f[0], first + f[1], first + f[2]});
  for (const Edge& e : mesh.edges()) all.edges.push_back({first + e[0], first + e[1]});
  for (const Index p : mesh.points()) all.points.push_back(first + p);
}

Parts parts_of(const TestWorld& world) {
  Parts all;
  for (std::size_t id = 0; id < world.bodies.size(); ++id)
    if (const TestBody& body = world.bodies[id]; body.is_there)
      add(all, static_cast<BodyId>(id), body.shape, body.motion);
  return all;
}

/// Which bodies meet, said again: a deforming one itself, any two of which one moves.
Options options_of(const TestWorld& world, const Parts& parts, Options options) {
  options.filter.accepts = [&world, names = parts.names](PairKind kind, const std::array<Index, 4>& v) {
    const BodyId a = names[place(v[0])][0], b = names[place(v[kind == PairKind::edge_edge ? 2 : 1])][0];
    const auto motion = [&](BodyId id) -> const BodyMotion& { return world.bodies[place(id)].motion; };
    if (a == b) return std::holds_alternative<Deforming>(motion(a)) && !world.kept_apart.contains({a, b});
    if (std::holds_alternative<Static>(motion(a)) && std::holds_alternative<Static>(motion(b))) return false;
    return !world.kept_apart.contains({std::min(a, b), std::max(a, b)});
  };
  const std::size_t count = world.bodies.size();
  options.filter.group_count = static_cast<Index>(count);
  options.filter.groups_may_touch.assign(count * count, 1);
  for (const auto& [body, own] : parts.names) options.filter.group_of_vertex.push_back(body);
  for (const TestBody& body : world.bodies) options.radii.push_back(body.radius);
  return options;
}

OneMesh one_mesh(const TestWorld& world, Options options, Parts parts) {
  Mesh mesh(static_cast<Index>(parts.start.size()), parts.faces, parts.edges, parts.points);
  Detector detector(std::move(mesh), options_of(world, parts, std::move(options)));
  return {parts.start, parts.end, parts.names,
          RigidPath(parts.rest, parts.body_of_vertex, parts.chains, parts.rest_end), std::move(detector)};
}

}  // namespace

OneMesh::OneMesh(const TestWorld& world, Options options)
    : OneMesh(one_mesh(world, std::move(options), parts_of(world))) {}

OneMesh::OneMesh(std::vector<Point> s, std::vector<Point> e, std::vector<std::array<Index, 2>> n, RigidPath p,
                 Detector d)
    : start(std::move(s)), end(std::move(e)), names(std::move(n)), path(std::move(p)), detector(std::move(d)) {}

void expect_same_bits(const EarliestBodyContact& a, const EarliestBodyContact& b) {
  EXPECT_EQ(a.toi_lower, b.toi_lower);
  EXPECT_EQ(a.toi_upper, b.toi_upper);
  ASSERT_EQ(a.contact.has_value(), b.contact.has_value());
  if (!a.contact) return;
  EXPECT_EQ(named(*a.contact), named(*b.contact));
  EXPECT_EQ(a.contact->toi_lower, b.contact->toi_lower);
  EXPECT_EQ(a.contact->toi_upper, b.contact->toi_upper);
  EXPECT_EQ(a.contact->u, b.contact->u);
  EXPECT_EQ(a.contact->v, b.contact->v);
  EXPECT_EQ(a.contact->normal, b.contact->normal);
  EXPECT_EQ(a.contact->certainty, b.contact->certainty);
}

void for_each_step(const std::function<void(TestWorld&)>& expect) {
  constexpr double kSize = 1.5;
  TestWorld world = random_world(7, kSize, Motions::any);
  Random random(8);
  for (int step = 0; step < 12; ++step) {
    SCOPED_TRACE(step);
    expect(world);
    const BodyId body = random.below(static_cast<int>(world.bodies.size()));
    world.move(body, random_motion(random, world.bodies[place(body)].shape, kSize, Motions::any));
  }
}

}  // namespace tamis::test
