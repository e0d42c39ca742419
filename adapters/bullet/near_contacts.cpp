#include "adapters/bullet/near_contacts.hpp"

#include <BulletCollision/CollisionDispatch/btManifoldResult.h>

#include <algorithm>
#include <cmath>
#include <tuple>

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

}  // namespace

Surface::Surface(const Shape& shape) : mesh(shape), radius(0), faces_at(shape.points().size()) {
  for (const Point& p : mesh.points()) {
    radius = std::max(radius, std::hypot(p[0], p[1], p[2]));
    points.push_back(vector_of(p));
  }
  for (const Face& face : mesh.mesh().faces())
    for (const Index vertex : face) faces_at[static_cast<std::size_t>(vertex)].push_back(face);
}

NearFeature::NearFeature(const Surface& of, std::span<const Index> its, const std::array<double, 3>& nearest)
    : surface(of),
      vertices(its),
      weights(nearest),
      heaviest(static_cast<std::size_t>(std::ranges::max_element(nearest) - nearest.begin())),
      point(0, 0, 0) {
  for (std::size_t i = 0; i < vertices.size(); ++i)
    if (vertices[i] >= 0)
      point += surface.points[static_cast<std::size_t>(vertices[i])] * static_cast<btScalar>(weights[i]);
}

std::span<const Face> NearFeature::faces() const {
  return surface.faces_at[static_cast<std::size_t>(vertices[heaviest])];
}

bool NearFeature::lies_on(const Face& face) const {
  if (is_vertex()) return true;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    if (weights[i] > kNoWeight && std::ranges::find(face, vertices[i]) == face.end()) return false;
  return true;
}

bool NearFeature::is_repeated() const {
  if (vertices.size() < 3) return false;
  const auto first = std::ranges::find_if(faces(), [&](const Face& face) { return lies_on(face); });
  return first != faces().end() && !std::ranges::equal(*first, vertices);
}

bool NearFeature::is_nearest(const btVector3& outward) const {
  const auto leads_away = [&](Index vertex) {
    const btVector3 way = surface.points[static_cast<std::size_t>(vertex)] - point;
    const btScalar along = way.dot(outward);
    return along <= 0 || along * along <= kLeadsAway * kLeadsAway * way.length2();
  };
  return std::ranges::all_of(faces(),
                             [&](const Face& face) { return !lies_on(face) || std::ranges::all_of(face, leads_away); });
}

namespace {

/// A contact, where it is needed to choose among those of two bodies.
struct Choice {
  std::array<long, 3> normal;  ///< in steps
  std::size_t number;
  btVector3 point;
  btScalar distance;
};

std::vector<Choice> by_normal(std::span<const NearContact> contacts) {
  std::vector<Choice> choices;
  choices.reserve(contacts.size());
  for (const NearContact& contact : contacts) {
    const btVector3 steps = kNormalSteps * contact.normal;
    choices.push_back({{std::lround(steps.x()), std::lround(steps.y()), std::lround(steps.z())},
                       choices.size(),
                       contact.sides[0].point(),
                       contact.distance()});
  }
  std::ranges::sort(choices, {}, [](const Choice& choice) { return std::tie(choice.normal, choice.number); });
  return choices;
}

}  // namespace

std::vector<NearContact> essential(std::span<const NearContact> contacts) {
  const std::vector<Choice> choices = by_normal(contacts);
  std::vector<bool> is_kept(contacts.size());
  const auto keep_least = [&](std::span<const Choice> among, const auto& value) {
    is_kept[std::ranges::min_element(among, {}, value)->number] = true;
  };
  for (auto begin = choices.begin(), end = begin; begin != choices.end(); begin = end) {
    end = std::find_if(begin, choices.end(), [&](const Choice& other) { return other.normal != begin->normal; });
    const std::span<const Choice> among(begin, end);
    btVector3 x, y;
    btPlaneSpace1(contacts[begin->number].normal, x, y);
    keep_least(among, [](const Choice& choice) { return choice.distance; });
    for (const btVector3& way : {x, y, x + y, x - y})
      for (const btScalar sign : {-1.0F, 1.0F})
        keep_least(among, [&](const Choice& choice) { return sign * way.dot(choice.point); });
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
