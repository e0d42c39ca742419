#include "tamis/world.hpp"

#include <string>

#include "api/validate.hpp"
#include "numbers/floating_point_state.hpp"
#include "numbers/number_text.hpp"
#include "search/topology/at.hpp"
#include "tamis/error.hpp"
#include "worlds/world_state.hpp"

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
  if (!state_) throw Error("the world has been moved from: use the world that it was moved to");
  return *state_;
}

BodyId World::add(const Shape& shape, BodyMotion motion) {
  std::vector<BodyMotion> one;
  one.push_back(std::move(motion));
  return add_many(shape, std::move(one)).front();
}

std::vector<BodyId> World::add_many(const Shape& shape, std::vector<BodyMotion> motions) {
  return State::Turn(*this)->add(shape.shape_, std::move(motions));
}

void World::move(BodyId body, BodyMotion motion) { State::Turn(*this)->move(body, std::move(motion)); }

void World::move_many(std::span<const BodyId> bodies, std::vector<BodyMotion> motions) {
  State::Turn(*this)->move(bodies, std::move(motions));
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
  const BodyPair pair[]{{a, b}};
  set_may_touch(pair, may_touch);
}

void World::set_may_touch(std::span<const std::array<BodyId, 2>> pairs, bool may_touch) {
  State::Turn(*this)->set_may_touch(pairs, may_touch);
}

const Statistics& World::statistics() const {
  const State& now = state();
  if (now.is_asked.test(std::memory_order_acquire)) throw Busy();
  return now.statistics;
}

}  // namespace tamis
