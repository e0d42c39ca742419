#include "integrations/bullet/throws/bodies.hpp"

#include <algorithm>
#include <array>
#include <ctime>
#include <memory>

#include "integrations/bullet/clamped_world.hpp"
#include "integrations/bullet/mesh_of_shape.hpp"
#include "integrations/bullet/throws/parts.hpp"
#include "integrations/clamp.hpp"

namespace tamis::bullet {
namespace {

/// A Bullet world with the bodies of a scene.
class Simulated {
 public:
  Simulated(const BodyScene& scene, bool clamped) : parts_(clamped) {
    parts_.world->setGravity(scene.gravity);
    for (const Body& body : scene.bodies) add(body, scene.sleep);
  }
  ~Simulated() {
    for (const auto& body : bodies_) parts_.world->removeRigidBody(body.get());
  }
  Simulated(const Simulated&) = delete;
  Simulated& operator=(const Simulated&) = delete;

  /// Returns how many questions the clamp asked; 0 without it.
  int step() {
    parts_.world->stepSimulation(1.0F / 60, 1, 1.0F / 60);
    const auto* const clamped = dynamic_cast<const ClampedWorld*>(parts_.world.get());
    return clamped ? clamped->last_step().questions : 0;
  }

  void record(BodyRun& run) const {
    std::vector<btTransform>& places = run.places.emplace_back();
    std::vector<btVector3>& velocities = run.velocities.emplace_back();
    for (const auto& body : bodies_) {
      places.push_back(body->getWorldTransform());
      velocities.push_back(body->getLinearVelocity());
    }
  }

 private:
  void add(const Body& body, Sleep sleep) {
    btVector3 inertia(0, 0, 0);
    if (body.mass > 0) body.shape->calculateLocalInertia(body.mass, inertia);
    btRigidBody::btRigidBodyConstructionInfo info(body.mass, nullptr, body.shape.get(), inertia);
    info.m_startWorldTransform = body.place;
    btRigidBody& added = *bodies_.emplace_back(std::make_unique<btRigidBody>(info));
    added.setLinearFactor(body.goes);
    added.setAngularFactor(body.turns);
    added.setLinearVelocity(body.velocity);
    added.setAngularVelocity(body.spin);
    parts_.world->addRigidBody(&added);
    if (body.mass > 0 && sleep == Sleep::never) added.setActivationState(DISABLE_DEACTIVATION);
    if (body.mass > 0 && sleep == Sleep::from_the_start) added.setActivationState(ISLAND_SLEEPING);
  }

  Parts parts_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
};

Triangles surface_of(const btCollisionShape& shape) {
  const Shape mesh = mesh_of(shape);
  return {mesh.points(), {mesh.mesh().faces().begin(), mesh.mesh().faces().end()}};
}

}  // namespace

BodyRun run_bodies(const BodyScene& scene, int steps, bool clamped) {
  BodyRun run;
  for (const Body& body : scene.bodies) {
    run.bodies.push_back(surface_of(*body.shape));
    run.masses.push_back(body.mass);
  }
  Simulated simulated(scene, clamped);
  simulated.record(run);
  double all = 0;
  int questions = 0;
  for (int i = 0; i < steps; ++i) {
    const std::clock_t begin = std::clock();
    questions += simulated.step();
    const double milliseconds = 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    all += milliseconds;
    run.slowest = std::max(run.slowest, milliseconds);
    simulated.record(run);
  }
  run.milliseconds = all / steps;
  run.questions = static_cast<double>(questions) / steps;
  return run;
}

std::vector<std::size_t> hanging(const BodyRun& run) {
  constexpr std::size_t kSteps = 40;
  constexpr btScalar kSpeed = 0.2F, kMoved = 1e-4F;
  std::vector<std::size_t> hanging;
  if (run.places.size() <= kSteps) return hanging;
  for (std::size_t body = 0; body < run.bodies.size(); ++body) {
    const btVector3 end = run.places.back()[body].getOrigin();
    bool hangs = run.masses[body] > 0;
    for (std::size_t i = run.places.size() - kSteps; hangs && i < run.places.size(); ++i)
      hangs = run.places[i][body].getOrigin().distance(end) < kMoved && run.velocities[i][body].length() > kSpeed;
    if (hangs) hanging.push_back(body);
  }
  return hanging;
}

double hanging_speed(const BodyRun& run) {
  double speed = 0;
  for (const std::size_t body : hanging(run)) speed = std::max(speed, double{run.velocities.back()[body].length()});
  return speed;
}

std::size_t overlapping(const BodyRun& run) {
  World world({.threads = 1});
  for (std::size_t body = 0; body < run.bodies.size(); ++body) {
    const Triangles& triangles = run.bodies[body];
    world.add({Mesh(static_cast<Index>(triangles.points.size()), triangles.faces), triangles.points},
              adapters::resting(pose_of(run.places.back()[body])));
  }
  return adapters::overlapping(world).size();
}

std::array<double, 2> momentum(const BodyRun& run) {
  std::array<double, 2> momentum{};
  for (std::size_t body = 0; body < run.bodies.size(); ++body) {
    momentum[0] += double{run.masses[body] * run.velocities.front()[body].x()};
    momentum[1] += double{run.masses[body] * run.velocities.back()[body].x()};
  }
  return momentum;
}

}  // namespace tamis::bullet
