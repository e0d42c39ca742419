// Small worlds, and the same as one mesh that moves on one path: what a detector says of that a world must say, too.
#pragma once
#include <cmath>
#include <functional>
#include <random>
#include <set>

#include "numbers/platform.hpp"
#include "scenes/shapes.hpp"
#include "tamis/detector.hpp"
#include "tamis/world.hpp"

namespace tamis::test {

inline std::size_t place(Index index) { return static_cast<std::size_t>(index); }

/// Worlds are small: more threads have nothing to do.
inline Options one_thread() {
  Options options;
  options.threads = 1;
  return options;
}

/// What a test puts into a world, kept so that it can be put into one mesh, too.
struct TestBody {
  Shape shape;
  BodyMotion motion;
  bool is_there = true;  ///< neither removed nor switched off
  double radius = 0;
};

struct TestWorld {
  World world;
  std::vector<TestBody> bodies;
  std::set<std::array<BodyId, 2>> kept_apart;

  explicit TestWorld(Options options = one_thread()) : world(std::move(options)) {}
  BodyId add(const Shape& shape, const BodyMotion& motion) {
    bodies.push_back({shape, motion});
    return world.add(shape, motion);
  }
  void set_radius(BodyId id, double radius) {
    bodies[place(id)].radius = radius;
    world.set_radius(id, radius);
  }
  void move(BodyId id, const BodyMotion& motion) {
    bodies[place(id)].motion = motion;
    world.move(id, motion);
  }
};

/// All bodies that are there, one behind the other.
struct OneMesh {
  std::vector<Point> start, end;            ///< of the step; of what turns, its doubles at both ends
  std::vector<std::array<Index, 2>> names;  ///< body, own vertex
  RigidPath path;
  Detector detector;

  explicit OneMesh(const TestWorld& world, Options options = one_thread());
  OneMesh(std::vector<Point> s, std::vector<Point> e, std::vector<std::array<Index, 2>> n, RigidPath p, Detector d);
  Step step() const { return {start, end}; }
};

/// Any pair, said of bodies and own vertices.
struct NamedPair {
  PairKind kind;
  std::array<std::array<Index, 2>, 4> vertices;
  auto operator<=>(const NamedPair&) const = default;
};

/// Of a pair of OneMesh, and of one of a world.
template <class Pair>
NamedPair named(const Pair& pair, const OneMesh& mesh) {
  NamedPair named{pair.kind, {}};
  for (std::size_t i = 0; i < 4; ++i)
    named.vertices[i] = pair.vertices[i] < 0 ? std::array<Index, 2>{-1, -1} : mesh.names[place(pair.vertices[i])];
  return named;
}
template <class Pair>
NamedPair named(const Pair& pair) {
  const bool is_pair_of_edges = pair.kind == PairKind::edge_edge;
  NamedPair named{pair.kind, {}};
  for (std::size_t i = 0; i < 4; ++i) {
    const bool is_first = i < (is_pair_of_edges ? 2 : 1);
    named.vertices[i] = pair.vertices[i] < 0 ? std::array<Index, 2>{-1, -1}
                                             : std::array<Index, 2>{pair.bodies[is_first ? 0 : 1], pair.vertices[i]};
  }
  return named;
}

/// Each number of both, and who touches.
void expect_same_bits(const EarliestBodyContact& a, const EarliestBodyContact& b);

/// The same numbers with every standard library, unlike the distributions of <random>.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double in(double low, double high) { return std::ldexp(static_cast<double>(engine_()), -64) * (high - low) + low; }
  int below(int count) { return static_cast<int>(high_product(engine_(), static_cast<std::uint64_t>(count))); }
  Point point(double size) { return {in(-size, size), in(-size, size), in(-size, size)}; }

 private:
  std::mt19937_64 engine_;
};

enum class Motions { straight, any };

/// What makes a random world a hard one.
struct Extremes {
  Point away{};            ///< all bodies are moved by this
  double turns = 1;        ///< what turns, turns so many times as far
  double every_other = 1;  ///< so many times as large is every other body
};

/// Some bodies within a cube of side 2 `size`: spheres, cubes, a sheet, a rod with loose points, shared by several.
TestWorld random_world(std::uint64_t seed, double size, Motions motions, const Options& options = one_thread(),
                       const Extremes& extremes = {});
BodyMotion random_motion(Random& random, const Shape& shape, double size, Motions motions);

/// Calls expect(world) in each of twelve steps of a random world. Between two steps one body gets another motion.
void for_each_step(const std::function<void(TestWorld&)>& expect);

}  // namespace tamis::test
