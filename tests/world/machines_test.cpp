// Machines and random bodies against an oracle that shares no code with the library: conservative advancement in long
// double over all pairs of features (tests/oracle/bodies.hpp).
#include "scenes/machines.hpp"

#include <gtest/gtest.h>

#include "oracle/bodies.hpp"
#include "support/test_names.hpp"
#include "world/random_world.hpp"

namespace tamis::test {
namespace {

using scenes::Machine;

oracle::TurningBody for_oracle(const scenes::Shape& shape, const Link& way) {
  return {shape.points, shape.faces, {way.start.rotation, way.end.rotation, way.start.position, way.end.position}};
}

/// Above 1: never.
double true_first_touch(const Machine& machine, const std::vector<double>& radii, double separation) {
  oracle::Real first = 2;
  for (std::size_t i = 0; i < machine.parts.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const auto body = [&](std::size_t k) {
        return for_oracle(machine.shapes[machine.parts[k].shape], machine.parts[k].way);
      };
      first = std::min(first, oracle::first_touch(body(i), body(j), separation + radii[i] + radii[j]));
    }
  return static_cast<double>(first);
}

World world_of(const Machine& machine, const std::vector<double>& radii, int threads) {
  Options options;
  options.threads = threads;
  World world(options);
  std::vector<Shape> shapes;
  for (const scenes::Shape& s : machine.shapes)
    shapes.emplace_back(Mesh(static_cast<Index>(s.points.size()), s.faces), s.points);
  for (std::size_t i = 0; i < machine.parts.size(); ++i) {
    const auto& [shape, way] = machine.parts[i];
    const bool stands = way.start.position == way.end.position && way.start.rotation == way.end.rotation;
    const BodyId id = world.add(shapes[shape], stands ? BodyMotion(Static{way.start}) : BodyMotion(Rigid{{way}}));
    world.set_radius(id, radii[i]);
  }
  return world;
}

/// Returns whether they touch.
bool expect_truth(const Machine& machine, const std::vector<double>& radii, double separation) {
  const double truth = true_first_touch(machine, radii, separation);
  World world = world_of(machine, radii, 1), threaded = world_of(machine, radii, 3);
  const QueryOptions asked{.min_separation = separation};
  const EarliestBodyContact first = world.earliest(asked), same = threaded.earliest(asked);
  EXPECT_EQ(first.contact.has_value(), truth <= 1);
  EXPECT_EQ(world.is_free(asked), truth > 1);
  EXPECT_EQ(world.contacts(asked).empty(), truth > 1);
  if (truth <= 1) {
    EXPECT_NEAR(first.toi_lower, truth, 1e-8);
  }
  EXPECT_EQ(first.toi_lower, same.toi_lower);
  EXPECT_EQ(world.contacts(asked).size(), threaded.contacts(asked).size());
  return truth <= 1;
}

bool expect_truth(const Machine& machine, double separation = 0) {
  return expect_truth(machine, std::vector<double>(machine.parts.size(), 0), separation);
}

// Bug: a tooth passes through its neighbour between two chords; a tooth that only comes near stops the train.
TEST(Machines, Gears) {
  EXPECT_FALSE(expect_truth(scenes::gear_train(3, 8, 0.2, false)));
  EXPECT_TRUE(expect_truth(scenes::gear_train(3, 8, 0.2, true)));
  EXPECT_TRUE(expect_truth(scenes::gear_train(3, 8, -0.2, false), 0.08));
}

TEST(Machines, NutOnABolt) {
  EXPECT_FALSE(expect_truth(scenes::nut_on_bolt(6, 0.015, false)));
  EXPECT_TRUE(expect_truth(scenes::nut_on_bolt(6, 2, true)));
}

TEST(Machines, ChainNet) {
  EXPECT_FALSE(expect_truth(scenes::chain_net(3, 8, 4, 0.01)));
  EXPECT_TRUE(expect_truth(scenes::chain_net(3, 8, 4, 0.5)));
  EXPECT_TRUE(expect_truth(scenes::chain_net(3, 8, 4, 0.05), 0.22));
}

TEST(Machines, Tunnel) {
  EXPECT_FALSE(expect_truth(scenes::tunnel(2, 0)));
  EXPECT_FALSE(expect_truth(scenes::tunnel(2, 0.005)));
  EXPECT_TRUE(expect_truth(scenes::tunnel(2, 0.1)));
  EXPECT_TRUE(expect_truth(scenes::tunnel(2, 0.005), 0.02));
}

/// Two bodies from anywhere near, one of which may stand.
Machine random_bodies(Random& random) {
  Machine machine{{scenes::unit_cube(1), scenes::unit_sphere(1)}, {}};
  for (int i = 0; i < 2; ++i) {
    const double away = i == 0 ? 0 : 4;
    Link way{{random.point(1), random.point(2)}, {random.point(1), random.point(2)}};
    way.start.position[0] += away;
    if (random.below(4) == 0) way.end = way.start;
    machine.parts.push_back({place(random.below(2)), way});
  }
  return machine;
}

// Bug: a radius that is not taken twice, or by one of both alone; a separation that is left out on curves.
TEST(Machines, RandomBodiesWithRadii) {
  Random random(8);
  int touching = 0, asked = 0;
  for (int i = 0; i < 50; ++i) {
    const Machine machine = random_bodies(random);
    const std::vector<double> radii{random.below(2) * random.in(0, 0.3), random.below(2) * random.in(0, 0.3)};
    const double separation = random.below(2) * random.in(0, 0.2);
    if (true_first_touch(machine, radii, separation) == 0) continue;  // where it starts
    ++asked;
    touching += expect_truth(machine, radii, separation);
  }
  EXPECT_GT(touching, 8);
  EXPECT_GT(asked - touching, 8);
}

}  // namespace
}  // namespace tamis::test
