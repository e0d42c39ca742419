#include "scenes/simulation/simulator.hpp"

#include <algorithm>
#include <span>
#include <string>
#include <tuple>

#include "scenes/simulation/zones.hpp"
#include "tamis/error.hpp"

namespace tamis::simulation {
namespace {

/// Rounds in which contacts of a failed proof become constraints, before zones take over.
constexpr int kRepairRounds = 6;
/// Passes over all contact constraints in a repair round.
constexpr int kRepairPasses = 4;
constexpr int kZoneRounds = 30;
/// A substep is halved at most this often; if the smallest part fails, the simulation ends.
constexpr int kHalvings = 8;

Options options_of(const Model& model, double separation) {
  Options options;
  options.min_separation = separation;
  options.filter = model.pair_filter();
  return options;
}

std::vector<Index> bodies_of(const Model& model) {
  std::vector<Index> body(static_cast<std::size_t>(model.mesh_vertices()), -1);
  const auto pinned = static_cast<Index>(model.obstacles.size());
  for (Index v = 0; v < model.mesh_vertices(); ++v)
    if (model.particles.inverse_mass[v] == 0) body[static_cast<std::size_t>(v)] = pinned;
  for (Index i = 0; i < pinned; ++i) {
    const Obstacle& obstacle = model.obstacles[static_cast<std::size_t>(i)];
    std::fill_n(body.begin() + obstacle.first, obstacle.count, i);
  }
  return body;
}

bool comes_before(const Contact& a, const Contact& b) {
  return std::tie(a.kind, a.vertices) < std::tie(b.kind, b.vertices);
}

template <class Constraint>
void reset(std::vector<Constraint>& constraints) {
  for (Constraint& c : constraints) c.reset();
}

template <class Constraint>
void project_all(std::vector<Constraint>& constraints, Particles& particles, double dt) {
  for (Constraint& c : constraints) c.project(particles, dt);
}

}  // namespace

Effort& Effort::operator+=(const Effort& other) {
  substeps += other.substeps;
  touches += other.touches;
  repairs += other.repairs;
  zone_vertices += other.zone_vertices;
  return *this;
}

Simulator::Simulator(Model model)
    : model_(std::move(model)),
      near_(model_.mesh(), options_of(model_, model_.thickness)),
      proof_(model_.mesh(), options_of(model_, 0)),
      body_of_vertex_(bodies_of(model_)),
      start_(model_.particles.position) {
  if (proof_.has_intersection(step().start))
    throw Error("the scene's surfaces touch or pass through each other at the start: move them apart");
  const auto near = near_.contacts(step());
  near_at_start_.assign(near.begin(), near.end());
}

Step Simulator::step() const {
  const Index count = model_.mesh_vertices();
  return {{start_.data(), count}, {model_.particles.position.data(), count}};
}

void Simulator::resume(int frame, Points position, Points velocity) {
  frame_ = frame;
  model_.particles.position = std::move(position);
  model_.particles.velocity = std::move(velocity);
}

void Simulator::advance() {
  effort_ = {};
  const double begin = frame_ * model_.frame_time, full = model_.frame_time / model_.substeps;
  // A part of a substep is halved until its path is free. Parts are counted in units of the smallest, so that no time
  // is lost.
  constexpr int kWhole = 1 << kHalvings;
  for (int done = 0, part = kWhole; done < model_.substeps * kWhole; ++effort_.substeps) {
    if (try_substep(begin + full * done / kWhole, full * part / kWhole)) {
      done += part;
      while (part < kWhole && done % (2 * part) == 0) part *= 2;
    } else if ((part /= 2) == 0) {
      throw Error("frame " + std::to_string(frame_ + 1) +
                  ": something is caught between obstacles that leave it no room: give it more, or less friction");
    }
  }
  ++frame_;
}

bool Simulator::try_substep(double time, double dt) {
  Particles& particles = model_.particles;
  start_ = particles.position;
  const Points velocity = particles.velocity;
  predict(time, dt);
  std::vector<Touch> touches = touches_near_path();
  solve(touches, dt);
  if (!make_free(touches, time, dt)) {
    particles.position = start_;
    particles.velocity = velocity;
    return false;
  }
  effort_.touches += touches.size();
  particles.velocity = (1 - model_.drag * dt) / dt * (particles.position - start_);
  return true;
}

void Simulator::predict(double time, double dt) {
  Particles& particles = model_.particles;
  for (const Gas& gas : model_.gases) gas.accelerate(particles, time, dt);
  for (Index v = 0; v < particles.count(); ++v)
    if (particles.inverse_mass[v] > 0)
      particles.position.col(v) += dt * (particles.velocity.col(v) + dt * model_.gravity);
  for (const Obstacle& obstacle : model_.obstacles) {
    const Eigen::Isometry3d motion = obstacle.motion(time, time + dt);
    for (Index v = obstacle.first; v < obstacle.first + obstacle.count; ++v)
      particles.position.col(v) = motion * start_.col(v);
  }
}

std::vector<Touch> Simulator::touches_near_path() {
  std::vector<Touch> touches;
  for (const Contact& c : near_.contacts(step()))
    if (!std::binary_search(near_at_start_.begin(), near_at_start_.end(), c, comes_before))
      touches.push_back(make_touch(c, start_, model_.thickness));
  return touches;
}

void Simulator::project_touches(const std::vector<Touch>& touches) {
  for (const Touch& touch : touches) project(touch, model_.particles, start_, model_.friction);
}

void Simulator::solve(const std::vector<Touch>& touches, double dt) {
  reset(model_.distances);
  reset(model_.bends);
  reset(model_.tetrahedra);
  reset(model_.attachments);
  for (int i = 0; i < model_.iterations; ++i) {
    project_all(model_.tetrahedra, model_.particles, dt);
    project_all(model_.attachments, model_.particles, dt);
    project_all(model_.bends, model_.particles, dt);
    project_all(model_.tethers, model_.particles, dt);
    project_all(model_.distances, model_.particles, dt);
    project_touches(touches);
  }
}

bool Simulator::make_free(std::vector<Touch>& touches, double time, double dt) {
  for (int round = 0; round < kRepairRounds; ++round) {
    std::span<const Contact> found = proof_.contacts(step());
    if (found.empty()) return true;
    ++effort_.repairs;
    for (const Contact& c : found) touches.push_back(make_touch(c, start_, model_.thickness));
    for (int pass = 0; pass < kRepairPasses; ++pass) project_touches(touches);
  }
  return move_in_zones(time, dt);
}

bool Simulator::move_in_zones(double time, double dt) {
  std::vector<Eigen::Isometry3d> motions;
  for (const Obstacle& obstacle : model_.obstacles) motions.push_back(obstacle.motion(time, time + dt));
  motions.push_back(Eigen::Isometry3d::Identity());
  Zones zones(model_.mesh_vertices());
  for (int round = 0; round < kZoneRounds; ++round) {
    std::span<const Contact> found = proof_.contacts(step());
    if (found.empty()) {
      effort_.zone_vertices += static_cast<std::uint64_t>(zones.size());
      return true;
    }
    zones.join(found);
    if (!zones.move(model_.particles, start_, body_of_vertex_, motions)) return false;
  }
  return false;
}

}  // namespace tamis::simulation
