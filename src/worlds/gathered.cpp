#include "worlds/gathered.hpp"

#include <algorithm>

#include "numbers/held_bytes.hpp"
#include "numbers/raw_array.hpp"
#include "search/topology/at.hpp"

namespace tamis {
namespace {

const Body& member(const BodyList& bodies, BodyId id) { return *bodies[at(id)]; }

/// A greedy coloring of the bodies: bodies that may meet have different colors. Passive bodies have 0.
std::map<BodyId, Index> colors_of(const NearItems& items, const BodyList& bodies, MotionKind least) {
  std::map<BodyId, std::vector<BodyId>> met_before;  // for each body those with smaller numbers
  for (const BodyPair& pair : items.pairs) met_before[pair[1]].push_back(pair[0]);
  std::map<BodyId, Index> colors;
  for (const auto& [id, unused] : items.of_body) {
    if (member(bodies, id).motion_kind() < least) {
      colors[id] = 0;
      continue;
    }
    std::set<Index> taken;
    for (const BodyId other : met_before[id]) taken.insert(colors.at(other));
    Index color = 1;
    while (taken.contains(color)) ++color;
    colors[id] = color;
  }
  return colors;
}

}  // namespace

Gathered::Gathered(const BodyList& bodies, NearItems items, MotionKind least, const std::set<BodyPair>& excluded_pairs,
                   const Options& options)
    : items_(std::move(items)),
      least_(least),
      carriers_(carriers(bodies)),
      detector_(make_detector(bodies, excluded_pairs, options)),
      body_pairs_(make_body_pairs()) {}

Detector Gathered::make_detector(const BodyList& bodies, const std::set<BodyPair>& excluded_pairs, Options options) {
  Mesh mesh = make_mesh(bodies);
  options.filter = make_filter(bodies, excluded_pairs);
  Detector detector(std::move(mesh), std::move(options));
  std::vector<double> radii;
  for (const Vertex& vertex : vertices_) radii.push_back(member(bodies, vertex.body).radius());
  DetectorAccess::lock(detector)->set_radii(std::move(radii));
  return detector;
}

Mesh Gathered::make_mesh(const BodyList& bodies) {
  std::vector<Face> faces;
  std::vector<Edge> edges;
  std::vector<Index> points;
  for (const auto& [id, items] : items_.of_body) {
    const BodyShape& shape = member(bodies, id).shape();
    IndexSet used(shape.mesh.vertex_count());
    items.for_each([&](Index item) {
      for (const Index own : shape.corners_of(item)) used.add(own);
    });
    RawArray<Index> here(at(shape.mesh.vertex_count()));  // few are used
    used.for_each([&, body = id](Index own) {
      here[at(own)] = static_cast<Index>(vertices_.size());
      vertices_.push_back({body, own});
    });
    items.for_each([&](Index item) {
      const Face corners = shape.corners_of(item);
      const Face face{here[at(corners[0])], here[at(corners[1])], here[at(corners[2])]};
      if (at(item) < shape.mesh.faces().size())
        faces.push_back(face);
      else if (at(item) < shape.mesh.faces().size() + shape.loose.edges.size())
        edges.push_back({face[0], face[1]});
      else
        points.push_back(face[0]);
    });
    motion_kinds_.push_back(member(bodies, id).motion_kind());
  }
  return {static_cast<Index>(vertices_.size()), std::move(faces), edges, std::move(points)};
}

/// A group of the detector holds the bodies of one color. Its pairs need no query. The bodies are not near each other,
/// or are passive. So there are few groups, however many bodies and radii.
PairFilter Gathered::make_filter(const BodyList& bodies, const std::set<BodyPair>& excluded_pairs) const {
  const std::map<BodyId, Index> colors = colors_of(items_, bodies, least_);
  std::size_t count = 1;
  for (const auto& [id, color] : colors) count = std::max(count, at(color) + 1);
  PairFilter filter;
  filter.group_count = static_cast<Index>(count);
  filter.group_of_vertex.reserve(vertices_.size());
  for (const Vertex& vertex : vertices_) filter.group_of_vertex.push_back(colors.at(vertex.body));
  filter.groups_may_touch.assign(count * count, 1);
  for (std::size_t group = 0; group < count; ++group) filter.groups_may_touch[group * count + group] = 0;
  // Both bodies of an excluded pair may be here because each is near a third.
  const auto is_here = [&](BodyId id) { return items_.of_body.contains(id); };
  std::set<BodyPair> excluded;
  for (const BodyPair& pair : excluded_pairs)
    if (is_here(pair[0]) && is_here(pair[1])) excluded.insert(pair);
  // The carrier of each body, if there are fewer of these.
  std::map<BodyId, BodyId> carrier_of;
  for (const auto& [id, unused] : items_.of_body) carrier_of.emplace(id, carriers_[carrier_of.size()]);
  if (std::set(carriers_.begin(), carriers_.end()).size() == carriers_.size()) carrier_of.clear();
  if (excluded.empty() && carrier_of.empty()) return filter;
  filter.accepts = [this, excluded, carrier_of](PairKind kind, const PairVertices& v) {
    const BodyId a = body_of(v[0]), b = body_of(v[second_feature(kind)]);
    return !excluded.contains({std::min(a, b), std::max(a, b)}) &&
           (carrier_of.empty() || carrier_of.at(a) != carrier_of.at(b));
  };
  return filter;
}

BodyPairs Gathered::make_body_pairs() const {
  std::map<BodyId, Index> places;
  for (const auto& [id, unused] : items_.of_body) places.emplace(id, static_cast<Index>(places.size()));
  std::vector<Index> place_of_vertex;
  place_of_vertex.reserve(vertices_.size());
  for (const Vertex& vertex : vertices_) place_of_vertex.push_back(places.at(vertex.body));
  std::vector<std::array<Index, 2>> pairs;
  pairs.reserve(items_.pairs.size());
  for (const auto& [a, b] : items_.pairs) pairs.push_back({places.at(a), places.at(b)});
  return {static_cast<Index>(places.size()), std::move(place_of_vertex), pairs};
}

std::vector<BodyId> Gathered::body_ids() const {
  std::vector<BodyId> ids;
  for (const auto& [id, unused] : items_.of_body) ids.push_back(id);
  return ids;
}

std::vector<BodyId> Gathered::carriers(const BodyList& bodies) const {
  return least_ == MotionKind::turning ? first_of_carrier(bodies, body_ids()) : body_ids();
}

bool Gathered::keeps_motion_kinds(const BodyList& bodies) const {
  auto kind = motion_kinds_.begin();
  for (const auto& [id, unused] : items_.of_body)
    if (!bodies[at(id)] || member(bodies, id).motion_kind() != *kind++) return false;
  return carriers(bodies) == carriers_;
}

Positions Gathered::start(const BodyList& bodies) {
  start_.clear();
  for (const auto& [id, own] : vertices_) start_.push_back(member(bodies, id).start_of(own));
  return start_;
}

Step Gathered::step(const BodyList& bodies) {
  end_.clear();
  for (const auto& [id, own] : vertices_) end_.push_back(member(bodies, id).end_of(own));
  return {start(bodies), end_};
}

/// Bodies that do not turn move straight between positions rounded to doubles, as in a step.
RigidPath Gathered::path(const BodyList& bodies) const {
  std::vector<Point> rest, rest_end;
  std::vector<Index> number_of_body;
  std::vector<RigidChain> chains;
  BodyId last = -1;
  for (const auto& [id, own] : vertices_) {
    const Body& body = member(bodies, id);
    const bool turns = body.motion_kind() == MotionKind::turning;
    if (id != last) chains.push_back(turns ? body.chain() : RigidChain());
    last = id;
    number_of_body.push_back(static_cast<Index>(chains.size()) - 1);
    rest.push_back(turns ? body.shape().points[at(own)] : body.start_of(own));
    rest_end.push_back(turns ? rest.back() : body.end_of(own));
  }
  return {std::move(rest), std::move(number_of_body), std::move(chains), std::move(rest_end)};
}

void Gathered::name(BodyIntersection& row) const {
  row.bodies = {body_of(row.edge[0]), body_of(row.face[0])};
  to_own(row.edge);
  to_own(row.face);
}

std::uint64_t Gathered::memory_bytes() const {
  return held_bytes(items_, vertices_, start_, end_, body_pairs_) + detector_.statistics().memory_bytes;
}

}  // namespace tamis
