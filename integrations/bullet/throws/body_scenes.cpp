#include "integrations/bullet/throws/body_scenes.hpp"

#include <array>
#include <memory>

#include "integrations/bullet/throws/random.hpp"

namespace tamis::bullet {
namespace {

using AnyShape = std::shared_ptr<btCollisionShape>;

constexpr btScalar kThickness = 0.005F, kPegHalfLength = 0.2F;

btTransform at(const btVector3& position) { return btTransform(btQuaternion::getIdentity(), position); }

AnyShape box_shape(const btVector3& half) { return std::make_shared<btBoxShape>(half); }

Body floor_of(btScalar half_side) { return {box_shape({half_side, 0.5F, half_side}), 0, at({0, -0.5F, 0})}; }

/// Four walls around a square of 2 * half_side, a little apart from each other and from the floor.
void add_walls(btScalar half_side, btScalar half_height, BodyScene& scene) {
  const btScalar half = half_side + 0.1F, along = half_side - 0.002F, height = half_height + 0.002F;
  for (const btScalar sign : {-1.0F, 1.0F}) {
    scene.bodies.push_back({box_shape({0.1F, half_height, along}), 0, at({sign * half, height, 0})});
    scene.bodies.push_back({box_shape({along, half_height, 0.1F}), 0, at({0, height, sign * half})});
  }
}

AnyShape hull_of(Random& random) {
  auto hull = std::make_shared<btConvexHullShape>();
  for (int i = 0; i < 14; ++i) hull->addPoint(random.vector(1).normalized() * 0.15F, false);
  hull->setMargin(0.002F);
  hull->recalcLocalAabb();
  return hull;
}

/// An L of two boxes, which it owns.
AnyShape compound_of_two() {
  const AnyShape part = box_shape({0.12F, 0.03F, 0.03F});
  auto* const both = new btCompoundShape;
  both->addChildShape(at({0.05F, -0.06F, 0}), part.get());
  both->addChildShape(btTransform(btQuaternion({0, 0, 1}, SIMD_HALF_PI), {-0.06F, 0.06F, 0}), part.get());
  return AnyShape(both, [part](btCompoundShape* compound) { delete compound; });
}

AnyShape shape_of_sort(int sort, Random& random) {
  switch (sort) {
    case 0:
      return box_shape({0.1F, 0.07F, 0.12F});
    case 1:
      return hull_of(random);
    case 2:
      return box_shape({0.2F, kThickness / 2, 0.15F});
    case 3:
      return box_shape({0.25F, 0.01F, 0.01F});
    default:
      return compound_of_two();
  }
}

}  // namespace

BodyScene pile(int plates, double drop) {
  BodyScene scene{{floor_of(5)}};
  const AnyShape plate = box_shape({0.5F, kThickness / 2, 0.5F});
  const auto above = static_cast<btScalar>(drop);
  for (int i = 0; i < plates; ++i) {
    const auto height = kThickness / 2 + above + static_cast<btScalar>(i) * (kThickness + above);
    scene.bodies.push_back({plate, 1, at({0.01F * static_cast<btScalar>(i % 3), height, 0})});
  }
  return scene;
}

std::size_t plates_inside(const BodyRun& run) {
  btScalar top_below = 0;
  std::size_t inside = 0;
  for (std::size_t plate = 1; plate < run.bodies.size(); ++plate) {
    const btScalar height = run.places.back()[plate].getOrigin().y();
    inside += height - kThickness / 2 <= top_below;
    top_below = height + kThickness / 2;
  }
  return inside;
}

BodyScene drop_of_a_box(unsigned seed) {
  Random random(seed);
  const auto size = static_cast<btScalar>(std::array<double, 3>{0.1, 0.3, 1}[seed % 3]);
  const auto speed = static_cast<btScalar>(random.between(2, 40));
  const btTransform place(random.turn(), {0, 2 * size, 0});
  btVector3 velocity = random.vector(double{speed} / 4);
  velocity.setY(-speed);
  return {{floor_of(50), {box_shape(btVector3(0.3F, 0.2F, 0.4F) * size), 1, place, velocity, random.vector(5)}}};
}

BodyScene pit(btScalar half_side) {
  BodyScene scene{{floor_of(5)}};
  add_walls(half_side, 10, scene);
  return scene;
}

BodyScene mixed_bodies(unsigned seed) {
  BodyScene scene = pit(1);
  Random random(seed);
  for (int i = 0; i < 30; ++i) {
    const btVector3 position =
        random.vector(0.6) * btVector3(1, 0, 1) + btVector3(0, 0.5F + 0.6F * static_cast<btScalar>(i), 0);
    scene.bodies.push_back({shape_of_sort(i % 5, random), 1, btTransform(random.turn(), position),
                            random.vector(6) - btVector3(0, 6, 0), random.vector(10)});
  }
  return scene;
}

BodyScene blocks(int side) {
  constexpr btScalar kHalf = 0.1F;
  BodyScene scene{{floor_of(5)}};
  const AnyShape block = box_shape({kHalf, kHalf, kHalf});
  const auto along = [](int i) { return 2 * kHalf * static_cast<btScalar>(i); };
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      for (int z = 0; z < side; ++z) scene.bodies.push_back({block, 1, at({along(x), kHalf + along(y), along(z)})});
  return scene;
}

BodyScene stacks(int boxes, Sleep sleep) {
  constexpr int kHigh = 4;
  constexpr btScalar kHalf = 0.1F, kGap = 0.001F;
  BodyScene scene{{floor_of(20)}};
  scene.sleep = sleep;
  const AnyShape shape = box_shape({kHalf, kHalf, kHalf});
  for (int i = 0; i < boxes; ++i) {
    const int stack = i / kHigh;
    const auto height = kHalf + kGap + static_cast<btScalar>(i % kHigh) * (2 * kHalf + kGap);
    scene.bodies.push_back(
        {shape, 1, at({0.5F * static_cast<btScalar>(stack % 20), height, 0.5F * static_cast<btScalar>(stack / 20)})});
  }
  return scene;
}

BodyScene peg_in_tube(double clearance) {
  constexpr btScalar kHalf = 0.05F;
  BodyScene scene{{floor_of(5)}};
  add_walls(kHalf + static_cast<btScalar>(clearance), 0.5F, scene);
  scene.bodies.push_back({box_shape({kHalf, kPegHalfLength, kHalf}), 1, at({0, 1, 0})});
  return scene;
}

double peg_above_floor(const BodyRun& run) { return double{run.places.back().back().getOrigin().y() - kPegHalfLength}; }

BodyScene row_of_cubes(int cubes) {
  BodyScene scene;
  scene.gravity = {0, 0, 0};
  const AnyShape cube = box_shape({0.2F, 0.2F, 0.2F});
  for (int i = 0; i < cubes; ++i) scene.bodies.push_back({cube, 1, at({0.4015F * static_cast<btScalar>(i), 0, 0})});
  scene.bodies[0].place.setOrigin({-1, 0, 0});
  scene.bodies[0].velocity = {5, 0, 0};
  return scene;
}

}  // namespace tamis::bullet
