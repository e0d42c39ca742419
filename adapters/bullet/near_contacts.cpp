#include "adapters/bullet/near_contacts.hpp"

#include <BulletCollision/CollisionDispatch/btManifoldResult.h>

#include <algorithm>
#include <cmath>

#include "adapters/bullet/mesh_of_shape.hpp"

namespace tamis::bullet {
namespace {

/// A sine: faces that lean towards the other body by no more than this still count as leading away. Bodies that lie on
/// each other within two gaps are tilted by at most two gaps over their size, which is this sine if they are twenty
/// gaps large.
constexpr btScalar kLeadsAway = 0.1F;
/// Normals count as one where they agree in these steps.
constexpr btScalar kNormalSteps = 1000;
/// Weights below this belong to vertices on which the nearest point does not lie.
constexpr double kNoWeight = 1e-6;

btVector3 place_of(const Shape& mesh, Index vertex) {
  return vector_of(mesh.points()[static_cast<std::size_t>(vertex)]);
}

}  // namespace

Surface::Surface(const Shape& shape) : mesh(shape), radius(0), faces_at(shape.points().size()) {
  for (const Point& p : mesh.points()) radius = std::max(radius, std::hypot(p[0], p[1], p[2]));
  const auto faces = mesh.mesh().faces();
  for (std::size_t face = 0; face < faces.size(); ++face)
    for (const Index vertex : faces[face])
      faces_at[static_cast<std::size_t>(vertex)].push_back(static_cast<Index>(face));
}

NearSide NearFeature::side() const {
  btVector3 local(0, 0, 0);
  for (std::size_t i = 0; i < vertices.size(); ++i)
    if (vertices[i] >= 0) local += place_of(surface.mesh, vertices[i]) * static_cast<btScalar>(weights[i]);
  return {object, local};
}

bool NearFeature::is_nearest(const btVector3& outward) const {
  const btVector3 local = side().local, direction = object->getWorldTransform().getBasis().transpose() * outward;
  const auto has_point = [&](const Face& face) {
    for (std::size_t i = 0; i < vertices.size(); ++i)
      if (weights[i] > kNoWeight && std::ranges::find(face, vertices[i]) == face.end()) return false;
    return true;
  };
  const auto leads_away = [&](Index vertex) {
    const btVector3 way = place_of(surface.mesh, vertex) - local;
    return way.dot(direction) <= kLeadsAway * way.length();
  };
  const auto heaviest = static_cast<std::size_t>(std::ranges::max_element(weights) - weights.begin());
  return std::ranges::all_of(surface.faces_at[static_cast<std::size_t>(vertices[heaviest])], [&](Index index) {
    const Face& face = surface.mesh.mesh().faces()[static_cast<std::size_t>(index)];
    return !has_point(face) || std::ranges::all_of(face, leads_away);
  });
}

std::vector<NearContact> essential(std::span<const NearContact> contacts) {
  std::map<std::array<int, 3>, std::vector<std::size_t>> by_normal;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    std::array<int, 3> steps{};
    for (int k = 0; k < 3; ++k)
      steps[static_cast<std::size_t>(k)] = static_cast<int>(std::lround(kNormalSteps * contacts[i].normal[k]));
    by_normal[steps].push_back(i);
  }
  std::vector<bool> is_kept(contacts.size());
  const auto keep_least = [&](const std::vector<std::size_t>& among, const auto& value) {
    is_kept[*std::ranges::min_element(among, {}, [&](std::size_t i) { return value(contacts[i]); })] = true;
  };
  for (const auto& [steps, among] : by_normal) {
    btVector3 x, y;
    btPlaneSpace1(contacts[among[0]].normal, x, y);
    keep_least(among, [](const NearContact& contact) { return contact.distance(); });
    for (const btVector3& way : {x, y, x + y, x - y})
      for (const btScalar sign : {-1.0F, 1.0F})
        keep_least(among, [&](const NearContact& contact) { return sign * way.dot(contact.sides[0].point()); });
  }
  std::vector<NearContact> kept;
  for (std::size_t i = 0; i < contacts.size(); ++i)
    if (is_kept[i]) kept.push_back(contacts[i]);
  return kept;
}

SolverContacts::SolverContacts(btDispatcher& dispatcher, const Manifolds& last) : dispatcher_(dispatcher) {
  for (int i = 0; i < last.size(); ++i) {
    std::vector<btManifoldPoint>& points = last_[{last[i]->getBody0(), last[i]->getBody1()}];
    for (int k = 0; k < last[i]->getNumContacts(); ++k) points.push_back(last[i]->getContactPoint(k));
  }
}

void SolverContacts::add(const NearContact& contact, btScalar gap, Manifolds& all) {
  const auto& [first, second] = contact.sides;
  btPersistentManifold*& manifold = manifolds_[{first.object, second.object}];
  if (!manifold) {
    manifold = dispatcher_.getNewManifold(first.object, second.object);
    all.push_back(manifold);
  }
  btManifoldPoint point(first.local, second.local, contact.normal, std::max(btScalar(0), contact.distance() - gap));
  point.m_positionWorldOnA = first.point();
  point.m_positionWorldOnB = second.point();
  point.m_combinedFriction = gCalculateCombinedFrictionCallback(first.object, second.object);
  point.m_combinedRestitution = gCalculateCombinedRestitutionCallback(first.object, second.object);
  point.m_combinedRollingFriction = gCalculateCombinedRollingFrictionCallback(first.object, second.object);
  point.m_combinedSpinningFriction = gCalculateCombinedSpinningFrictionCallback(first.object, second.object);
  if (const int known = manifold->getCacheEntry(point); known < 0)
    manifold->addManifoldPoint(point, true);
  else if (point.getDistance() < manifold->getContactPoint(known).getDistance())
    manifold->replaceContactPoint(point, known);
}

void SolverContacts::start_warm() {
  for (const auto& [objects, manifold] : manifolds_)
    for (const btManifoldPoint& last : last_[objects])
      if (const int known = manifold->getCacheEntry(last); known >= 0)
        manifold->getContactPoint(known).m_appliedImpulse += last.m_appliedImpulse;
}

}  // namespace tamis::bullet
