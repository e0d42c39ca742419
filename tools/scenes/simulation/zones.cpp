#include "scenes/simulation/zones.hpp"

#include <map>
#include <span>

namespace tamis::simulation {
namespace {

struct Zone {
  Vec momentum = Vec::Zero();  ///< times the length of the step
  double mass = 0;
  const Eigen::Isometry3d* carrier = nullptr;
};

bool move_alike(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) { return a.isApprox(b, 1e-14); }

}  // namespace

Zones::Zones(Index vertices) : parent_(static_cast<std::size_t>(vertices), -1) {}

Index Zones::root(Index vertex) const {
  while (parent_[static_cast<std::size_t>(vertex)] != vertex) vertex = parent_[static_cast<std::size_t>(vertex)];
  return vertex;
}

void Zones::join(std::span<const Contact> contacts) {
  for (const Contact& c : contacts) {
    for (Index v : c.vertices) {
      if (parent_[static_cast<std::size_t>(v)] >= 0) continue;
      parent_[static_cast<std::size_t>(v)] = v;
      members_.push_back(v);
    }
    for (Index v : c.vertices) parent_[static_cast<std::size_t>(root(v))] = root(c.vertices[0]);
  }
}

bool Zones::move(Particles& particles, const Points& start, const std::vector<Index>& body_of_vertex,
                 const std::vector<Eigen::Isometry3d>& motions) const {
  std::map<Index, Zone> zones;
  for (Index v : members_) {
    Zone& zone = zones[root(v)];
    const Index body = body_of_vertex[static_cast<std::size_t>(v)];
    if (body < 0) {
      const double mass = 1 / particles.inverse_mass[v];
      zone.momentum += mass * (particles.position.col(v) - start.col(v));
      zone.mass += mass;
      continue;
    }
    const Eigen::Isometry3d& motion = motions[static_cast<std::size_t>(body)];
    if (zone.carrier && !move_alike(*zone.carrier, motion)) return false;
    zone.carrier = &motion;
  }
  for (Index v : members_) {
    if (body_of_vertex[static_cast<std::size_t>(v)] >= 0) continue;
    const Zone& zone = zones[root(v)];
    particles.position.col(v) =
        zone.carrier ? Vec(*zone.carrier * start.col(v)) : Vec(start.col(v) + zone.momentum / zone.mass);
  }
  return true;
}

}  // namespace tamis::simulation
