#include "adapters/bullet/throws/pile.hpp"

#include <ctime>
#include <vector>

#include "adapters/bullet/clamped_world.hpp"
#include "adapters/bullet/throws/parts.hpp"

namespace tamis::bullet {
namespace {

constexpr btScalar kThickness = 0.005F;

/// A floor and the plates above it.
class Pile {
 public:
  Pile(int plates, btScalar drop, bool clamped) : parts_(clamped) {
    parts_.world->setGravity({0, -10, 0});
    add(floor_, 0, {0, -0.5F, 0});
    for (int i = 0; i < plates; ++i) {
      const auto height = kThickness / 2 + drop + static_cast<btScalar>(i) * (kThickness + drop);
      add(plate_, 1, {0.01F * static_cast<btScalar>(i % 3), height, 0});
    }
  }
  ~Pile() {
    for (const auto& body : bodies_) parts_.world->removeRigidBody(body.get());
  }
  Pile(const Pile&) = delete;
  Pile& operator=(const Pile&) = delete;

  /// Returns how many questions the clamp asked; 0 without it.
  int step() {
    parts_.world->stepSimulation(1.0F / 60, 1, 1.0F / 60);
    const auto* const clamped = dynamic_cast<const ClampedWorld*>(parts_.world.get());
    return clamped ? clamped->last_step().questions : 0;
  }

  std::vector<btTransform> places() const {
    std::vector<btTransform> places;
    for (const auto& body : bodies_) places.push_back(body->getWorldTransform());
    return places;
  }

 private:
  void add(btCollisionShape& shape, btScalar mass, const btVector3& position) {
    btVector3 inertia(0, 0, 0);
    if (mass > 0) shape.calculateLocalInertia(mass, inertia);
    btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, &shape, inertia);
    info.m_startWorldTransform.setOrigin(position);
    bodies_.push_back(std::make_unique<btRigidBody>(info));
    parts_.world->addRigidBody(bodies_.back().get());
  }

  Parts parts_;
  btBoxShape floor_{{5, 0.5F, 5}}, plate_{{0.5F, kThickness / 2, 0.5F}};
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
};

}  // namespace

PileRun run_pile(int plates, double drop, int steps, bool clamped) {
  Pile pile(plates, static_cast<btScalar>(drop), clamped);
  PileRun run{{static_cast<std::size_t>(plates) + 1, box({0.5, kThickness / 2, 0.5})}, {pile.places()}};
  run.bodies[0] = box({5, 0.5, 5});
  int questions = 0;
  const std::clock_t begin = std::clock();
  for (int i = 0; i < steps; ++i) {
    questions += pile.step();
    run.places.push_back(pile.places());
  }
  run.milliseconds = 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC / steps;
  run.questions = static_cast<double>(questions) / steps;
  return run;
}

int plates_inside(const PileRun& run) {
  const std::vector<btTransform>& places = run.places.back();
  btScalar top_below = 0;
  int inside = 0;
  for (std::size_t plate = 1; plate < places.size(); ++plate) {
    const btScalar height = places[plate].getOrigin().y();
    inside += height - kThickness / 2 <= top_below;
    top_below = height + kThickness / 2;
  }
  return inside;
}

}  // namespace tamis::bullet
