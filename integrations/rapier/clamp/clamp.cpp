#include "integrations/rapier/clamp/clamp.h"

#include <algorithm>
#include <string>

#include "c/world.hpp"
#include "integrations/clamp.hpp"

namespace tamis::c {
namespace {

tamis_velocity velocity_of(const adapters::Velocity& velocity) {
  tamis_velocity result{};
  std::ranges::copy(velocity.linear, result.linear);
  std::ranges::copy(velocity.angular, result.angular);
  return result;
}

class Wanted final : public adapters::WantedStep {
 public:
  explicit Wanted(const tamis_wanted_step& step) : step_(step) {
    array(step.moving, step.moving_count, "moving");
    if (!step.pose || !step.radius || !step.collides || !step.shape || !step.inertia || !step.friction ||
        !step.velocity || !step.way || !step.set_way)
      throw InvalidArgument(
          "pose, radius, collides, shape, inertia, friction, velocity, way or set_way is NULL: give all nine "
          "functions");
  }

  std::span<const BodyId> moving() const override { return {step_.moving, step_.moving_count}; }
  Pose pose(BodyId body, double fraction) const override {
    tamis_pose pose{};
    step_.pose(step_.user, body, fraction, &pose);
    return pose_of(pose);
  }
  double seconds() const override { return step_.seconds; }
  double carried_at() const override { return step_.carried_at; }
  const Shape& shape(BodyId body) const override {
    const tamis_shape* const shape = step_.shape(step_.user, body);
    if (!shape || !shape->object)
      throw InvalidArgument("shape is NULL for body " + std::to_string(body) +
                            ": give the shape that it was added with");
    return *shape->object;
  }
  adapters::Inertia inertia(BodyId body) const override {
    tamis_inertia inertia{};
    step_.inertia(step_.user, body, &inertia);
    adapters::Inertia result;
    std::ranges::copy(inertia.inverse_mass, result.inverse_mass.begin());
    for (std::size_t i = 0; i < 9; ++i) result.inverse_inertia[i / 3][i % 3] = inertia.inverse_inertia[i];
    return result;
  }
  double friction(const adapters::BodyPair& bodies) const override {
    return step_.friction(step_.user, bodies[0], bodies[1]);
  }
  adapters::Velocity velocity(BodyId body) const override { return asked(step_.velocity, body); }
  adapters::Velocity way(BodyId body) const override { return asked(step_.way, body); }
  void set_way(BodyId body, const adapters::Velocity& way) override {
    const tamis_velocity given = velocity_of(way);
    step_.set_way(step_.user, body, &given);
  }
  double radius(BodyId body) const override { return step_.radius(step_.user, body); }
  bool collides(const adapters::BodyPair& bodies) const override {
    return step_.collides(step_.user, bodies[0], bodies[1]) != 0;
  }
  bool collides_at(const std::array<BodyId, 2>& bodies, const std::array<Index, 2>& vertices) const override {
    return !step_.collides_at || step_.collides_at(step_.user, bodies[0], vertices[0], bodies[1], vertices[1]) != 0;
  }

 private:
  adapters::Velocity asked(void (*of)(void*, int32_t, tamis_velocity*), BodyId body) const {
    tamis_velocity velocity{};
    of(step_.user, body, &velocity);
    adapters::Velocity result;
    std::ranges::copy(velocity.linear, result.linear.begin());
    std::ranges::copy(velocity.angular, result.angular.begin());
    return result;
  }

  const tamis_wanted_step& step_;
};

}  // namespace
}  // namespace tamis::c

using namespace tamis::c;

tamis_status tamis_world_clamp(tamis_world* world, const tamis_wanted_step* step, tamis_body_end* ends,
                               size_t* contact_count, tamis_clamped* clamped) {
  return with(world, [&](tamis_world& handle) {
    const tamis_wanted_step given = read_sized(step, "step");
    Wanted wanted(given);
    if (given.moving_count > 0) required(ends, "ends");
    required(contact_count, "contact_count");
    required(clamped, "clamped");
    handle.contacts.clear();
    const tamis::adapters::ClampOptions options{.gap = given.gap, .rounds = given.rounds};
    const tamis::adapters::Beginning beginning = tamis::adapters::beginning(*handle.object, wanted, options);
    tamis::adapters::ClampedStep result = tamis::adapters::clamp(*handle.object, wanted, beginning, options);
    std::ranges::transform(result.ends, ends, [](const tamis::adapters::BodyEnd& end) {
      return tamis_body_end{end.fraction, velocity_of(end.velocity)};
    });
    handle.contacts = std::move(result.limits);
    *contact_count = handle.contacts.size();
    *clamped = {result.questions, beginning.overlapping.size()};
  });
}
