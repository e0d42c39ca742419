#include "tamis/world.hpp"

#include <limits>
#include <string>

#include "detect/validate.hpp"
#include "numerics/floating_point_state.hpp"
#include "numerics/number_text.hpp"
#include "tamis/error.hpp"
#include "topology/at.hpp"
#include "world/world_state.hpp"

namespace tamis {

Shape::Shape(Mesh mesh, std::vector<Point> points, Isa isa)
    : shape_(computing([&] { return std::make_shared<const BodyShape>(std::move(mesh), std::move(points), isa); })) {}

const Mesh& Shape::mesh() const { return shape_->mesh; }
const std::vector<Point>& Shape::points() const { return shape_->points; }
std::uint64_t Shape::memory_bytes() const { return shape_->memory_bytes(); }

World::World(Options options) : state_(computing([&] { return std::make_unique<State>(std::move(options)); })) {}
World::~World() = default;
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;

World::State& World::state() const {
  if (!state_) throw Error("the world has been moved from: ask the one that it went to");
  return *state_;
}

BodyId World::add(const Shape& shape, BodyMotion motion) {
  const State::Turn now(*this);
  if (now->bodies.size() >= at(std::numeric_limits<BodyId>::max()))
    throw InvalidOptions("the world has had 2^31 - 1 bodies, and numbers are not given twice: make another world");
  const auto id = static_cast<BodyId>(now->bodies.size());
  now->bodies.push_back(std::make_unique<Body>(id, shape.shape_, std::move(motion)));
  now->forget_if_still(*now->bodies.back());
  return id;
}

void World::move(BodyId body, BodyMotion motion) {
  const State::Turn now(*this);
  now->move(body, std::move(motion));
}

const BodyMotion& World::motion(BodyId body) const {
  const State::Turn now(*this);
  return now->body(body).motion();
}

BodyPoints World::points_at(BodyId body, double time) const {
  const State::Turn now(*this);
  const Body& asked = now->body(body);
  if (!(time >= 0 && time <= 1)) throw InvalidOptions("the time is " + number_text(time) + ": give a number in [0, 1]");
  return asked.points_at(time);
}

void World::remove(BodyId body) {
  const State::Turn now(*this);
  now->forget_gathered(now->body(body));
  now->bodies[at(body)] = nullptr;
  std::erase_if(now->excluded_pairs, [&](const BodyPair& pair) { return pair[0] == body || pair[1] == body; });
}

void World::set_enabled(BodyId body, bool is_enabled) {
  const State::Turn now(*this);
  Body& switched = now->body(body);
  if (switched.is_enabled == is_enabled) return;
  switched.is_enabled = is_enabled;
  if (is_enabled)
    now->forget_if_still(switched);
  else
    now->forget_gathered(switched);
}

void World::set_radius(BodyId body, double radius) {
  const State::Turn now(*this);
  Body& thick = now->body(body);
  validate_distance(radius, "the radius of body " + std::to_string(body));
  if (thick.radius() == radius) return;
  thick.set_radius(radius);
  now->forget_gathered(thick);
}

void World::set_may_touch(BodyId a, BodyId b, bool may_touch) {
  const State::Turn now(*this);
  Body& first = now->body(a);
  const Body& second = now->body(b);
  if (a == b) {
    if (may_touch && !first.deforming())
      throw InvalidOptions("body " + std::to_string(a) + " does not deform, so it cannot touch itself: leave that out");
    first.may_touch_itself = may_touch;
    return;
  }
  if (may_touch && first.motion_kind() == MotionKind::still && second.motion_kind() == MotionKind::still)
    throw InvalidOptions(
        "bodies " + std::to_string(a) + " and " + std::to_string(b) +
        " both stay where they are, and two such bodies are never asked about: tell one of them a motion");
  const BodyPair pair{std::min(a, b), std::max(a, b)};
  const bool is_changed = may_touch ? now->excluded_pairs.erase(pair) > 0 : now->excluded_pairs.insert(pair).second;
  if (is_changed) now->forget_gathered(first);
}

const Statistics& World::statistics() const {
  const State& now = state();
  if (now.is_asked.test(std::memory_order_acquire)) throw Busy();
  return now.statistics;
}

}  // namespace tamis
