#include "adapters/rapier/clamp/clamp.h"

#include <algorithm>

#include "adapters/clamp.hpp"
#include "c/world.hpp"

namespace tamis::c {
namespace {

class Wanted final : public adapters::WantedStep {
 public:
  explicit Wanted(const tamis_wanted_step& step) : step_(step) {
    array(step.moving, step.moving_count, "moving");
    if (!step.pose || !step.radius || !step.collides)
      throw InvalidArgument("pose, radius or collides is NULL: give all three functions");
  }

  std::span<const BodyId> moving() const override { return {step_.moving, step_.moving_count}; }
  Pose pose(BodyId body, double fraction) const override {
    tamis_pose pose{};
    step_.pose(step_.user, body, fraction, &pose);
    return pose_of(pose);
  }
  double radius(BodyId body) const override { return step_.radius(step_.user, body); }
  bool collides(const adapters::BodyPair& bodies) const override {
    return step_.collides(step_.user, bodies[0], bodies[1]) != 0;
  }
  bool collides_at(const std::array<BodyId, 2>& bodies, const std::array<Index, 2>& vertices) const override {
    return !step_.collides_at || step_.collides_at(step_.user, bodies[0], vertices[0], bodies[1], vertices[1]) != 0;
  }

 private:
  const tamis_wanted_step& step_;
};

}  // namespace
}  // namespace tamis::c

using namespace tamis::c;

tamis_status tamis_world_clamp(tamis_world* world, const tamis_wanted_step* step, double* fractions,
                               size_t* contact_count, tamis_clamped* clamped) {
  return with(world, [&](tamis_world& handle) {
    const tamis_wanted_step given = read_sized(step, "step");
    const Wanted wanted(given);
    if (given.moving_count > 0) required(fractions, "fractions");
    required(contact_count, "contact_count");
    required(clamped, "clamped");
    handle.contacts.clear();
    const auto overlapping = tamis::adapters::overlapping(*handle.object, wanted);
    tamis::adapters::ClampedStep result =
        tamis::adapters::clamp(*handle.object, wanted, overlapping, {.gap = given.gap, .rounds = given.rounds});
    std::ranges::copy(result.fractions, fractions);
    handle.contacts = std::move(result.limits);
    *contact_count = handle.contacts.size();
    *clamped = {result.questions, overlapping.size()};
  });
}
