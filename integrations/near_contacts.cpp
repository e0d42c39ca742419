#include "integrations/near_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <variant>

namespace tamis::adapters {
namespace {

/// A sine: faces that lean towards the other body by no more than this still count as leading away. Bodies that lie on
/// each other within two gaps are tilted by at most two gaps over their size, which is this sine if they are twenty
/// gaps large.
constexpr double kLeadsAway = 0.1;
/// Normals count as one where they agree in these steps.
constexpr double kNormalSteps = 1000;
/// Weights below this belong to vertices on which the nearest point does not lie.
constexpr double kNoWeight = 1e-6;

}  // namespace

NearFeature::NearFeature(const Shape& of, std::span<const Index> its, const std::array<double, 3>& nearest)
    : shape(of),
      vertices(its),
      weights(nearest),
      heaviest(static_cast<std::size_t>(std::ranges::max_element(nearest) - nearest.begin())),
      point{0, 0, 0} {
  for (std::size_t i = 0; i < vertices.size(); ++i)
    if (vertices[i] >= 0) point = plus(point, times(weights[i], shape.points()[static_cast<std::size_t>(vertices[i])]));
}

std::span<const Index> NearFeature::faces() const { return shape.mesh().faces_of_vertex(vertices[heaviest]); }

bool NearFeature::lies_on(const Face& face) const {
  if (is_vertex()) return true;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    if (weights[i] > kNoWeight && std::ranges::find(face, vertices[i]) == face.end()) return false;
  return true;
}

bool NearFeature::is_repeated() const {
  if (vertices.size() < 3) return false;
  const auto first = std::ranges::find_if(faces(), [&](Index number) { return lies_on(face(number)); });
  return first != faces().end() && !std::ranges::equal(face(*first), vertices);
}

bool NearFeature::is_nearest(const Point& outward) const {
  const auto leads_away = [&](Index vertex) {
    const Point way = minus(shape.points()[static_cast<std::size_t>(vertex)], point);
    const double along = dot(way, outward);
    return along <= 0 || along * along <= kLeadsAway * kLeadsAway * dot(way, way);
  };
  return std::ranges::all_of(
      faces(), [&](Index number) { return !lies_on(face(number)) || std::ranges::all_of(face(number), leads_away); });
}

namespace {

/// A contact, where it is needed to choose among those of two bodies.
struct Choice {
  std::array<long, 3> normal;  ///< in steps
  std::size_t number;
  Point point;
  double distance;
};

std::vector<Choice> by_normal(std::span<const NearContact> contacts) {
  std::vector<Choice> choices;
  choices.reserve(contacts.size());
  for (const NearContact& contact : contacts) {
    const Point steps = times(kNormalSteps, contact.normal);
    choices.push_back({{std::lround(steps[0]), std::lround(steps[1]), std::lround(steps[2])},
                       choices.size(),
                       contact.points[0],
                       contact.distance()});
  }
  std::ranges::sort(choices, {}, [](const Choice& choice) { return std::tie(choice.normal, choice.number); });
  return choices;
}

/// Four directions along the plane that is perpendicular to a unit vector; with their opposites every 45 degrees.
std::array<Point, 4> directions_along(const Point& normal) {
  std::size_t least = 0;
  for (const std::size_t i : {1U, 2U})
    if (std::abs(normal[i]) < std::abs(normal[least])) least = i;
  Point axis{};
  axis[least] = 1;
  const Point across = cross(normal, axis), x = times(1 / length(across), across), y = cross(normal, x);
  return {x, y, plus(x, y), minus(x, y)};
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
    keep_least(among, [](const Choice& choice) { return choice.distance; });
    for (const Point& way : directions_along(contacts[begin->number].normal))
      for (const double sign : {-1.0, 1.0})
        keep_least(among, [&](const Choice& choice) { return sign * dot(way, choice.point); });
  }
  std::vector<NearContact> kept;
  for (std::size_t i = 0; i < contacts.size(); ++i)
    if (is_kept[i]) kept.push_back(contacts[i]);
  return kept;
}

namespace {

/// A body at one time.
class Placed {
 public:
  Placed(const World& world, const Bodies& bodies, BodyId body, double time)
      : shape_(bodies.shape(body)),
        pose_(pose_of(world.motion(body), time)),
        matrix_(rotation_matrix(pose_.rotation)) {}

  const Shape& shape() const { return shape_; }
  Point to_world(const Point& local) const { return plus(times(matrix_, local), pose_.position); }
  Point to_local_direction(const Point& v) const { return times_transposed(matrix_, v); }

 private:
  /// REQUIRES: a motion as a whole.
  static Pose pose_of(const BodyMotion& motion, double time) {
    const auto* const rigid = std::get_if<Rigid>(&motion);
    return rigid ? pose_at(rigid->chain, time) : std::get<Static>(motion).pose;
  }

  const Shape& shape_;
  Pose pose_;
  Matrix matrix_;
};

/// Two edges that are nearest at an end of one: that vertex and the other's face or edge are a pair, too.
bool is_said_by_a_vertex(const BodyNearPair& pair) {
  const auto is_end = [](double weight) { return weight == 0 || weight == 1; };
  return pair.kind == PairKind::edge_edge && (is_end(pair.u) || is_end(pair.v));
}

/// True if another pair of the same bodies has the same nearest points. Of two vertices the first is that of the
/// smaller body.
bool is_said_by_another(const BodyNearPair& pair, const std::array<NearFeature, 2>& features) {
  return features[0].is_repeated() || features[1].is_repeated() ||
         (pair.bodies[0] > pair.bodies[1] && features[0].is_vertex() && features[1].is_vertex());
}

/// Two bodies, in the order in which pairs of their features have them.
class Meeting {
 public:
  Meeting(const World& world, const Bodies& bodies, const std::array<BodyId, 2>& both, double time)
      : pair_(pair_of(both)),
        is_in_order_(pair_ == both),
        bodies_{Placed(world, bodies, both[0], time), Placed(world, bodies, both[1], time)} {}

  /// Adds what the pair of features says.
  void add(const BodyNearPair& pair, NearBodies& near) const {
    near.distance = std::min(near.distance, pair.distance);
    if (!(pair.distance > 0)) return;
    if (is_said_by_a_vertex(pair)) return;
    const std::array<NearFeature, 2> features = features_of(pair);
    if (is_said_by_another(pair, features)) return;
    if (features[0].is_nearest(bodies_[0].to_local_direction(times(-1, pair.direction))) &&
        features[1].is_nearest(bodies_[1].to_local_direction(pair.direction)))
      near.contacts.push_back(contact_of(features, pair.direction));
  }
  NearContact contact_of(const BodyContact& contact) const { return contact_of(features_of(contact), contact.normal); }

 private:
  /// The first one first. Keeps references.
  template <class Pair>
  std::array<NearFeature, 2> features_of(const Pair& pair) const {
    const auto all = weights_of(pair.kind, pair.u, pair.v);
    const std::span<const Index> vertices(pair.vertices);
    const std::size_t of_first = pair.kind == PairKind::edge_edge ? 2 : 1;
    std::array<std::array<double, 3>, 2> weights{};
    for (std::size_t i = 0; i < of_first; ++i) weights[0][i] = all[i];
    for (std::size_t i = of_first; i < all.size(); ++i) weights[1][i - of_first] = -all[i];
    return {NearFeature(bodies_[0].shape(), vertices.first(of_first), weights[0]),
            NearFeature(bodies_[1].shape(), vertices.subspan(of_first), weights[1])};
  }

  NearContact contact_of(const std::array<NearFeature, 2>& features, const Point& normal) const {
    const Point first = bodies_[0].to_world(features[0].point), second = bodies_[1].to_world(features[1].point);
    if (is_in_order_) return {pair_, {first, second}, normal};
    return {pair_, {second, first}, times(-1, normal)};
  }

  BodyPair pair_;
  bool is_in_order_;
  std::array<Placed, 2> bodies_;
};

/// The vertices that `Bodies::collides_at` wants.
std::array<Index, 2> a_vertex_of_each(const BodyNearPair& pair) {
  return {pair.vertices[0], pair.vertices[pair.kind == PairKind::edge_edge ? 2 : 1]};
}

}  // namespace

Near near_bodies(World& world, const Bodies& bodies, double distance) {
  Near near;
  const std::vector<BodyNearPair> pairs = world.pairs_within(distance);
  for (auto pair = pairs.begin(); pair != pairs.end();) {
    const auto end = std::find_if(pair, pairs.end(), [&](const auto& other) { return other.bodies != pair->bodies; });
    const BodyPair both = pair_of(pair->bodies);
    if (bodies.collides(both)) {
      const Meeting meeting(world, bodies, pair->bodies, 0);
      NearBodies found{distance, {}};
      std::for_each(pair, end, [&](const BodyNearPair& one) {
        if (bodies.collides_at(one.bodies, a_vertex_of_each(one))) meeting.add(one, found);
      });
      if (found.distance < distance) {
        NearBodies& all = near.try_emplace(both, NearBodies{distance, {}}).first->second;
        all.distance = std::min(all.distance, found.distance);
        all.contacts.insert(all.contacts.end(), found.contacts.begin(), found.contacts.end());
      }
    }
    pair = end;
  }
  for (auto& [both, found] : near) found.contacts = essential(found.contacts);
  return near;
}

NearContact contact_at(const World& world, const Bodies& bodies, const BodyContact& contact, double time) {
  return Meeting(world, bodies, contact.bodies, time).contact_of(contact);
}

}  // namespace tamis::adapters
