#include "integrations/bullet/truncated_world.hpp"

#include <algorithm>

#include "integrations/bullet/mesh_of_shape.hpp"

namespace tamis::bullet {

std::vector<Point> positions_of(const btSoftBody& body) {
  std::vector<Point> positions;
  for (int i = 0; i < body.m_nodes.size(); ++i) positions.push_back(point_of(body.m_nodes[i].m_x));
  return positions;
}

SoftFeatures features_of(const btSoftBody& body) {
  const auto index = [&](const btSoftBody::Node* node) { return static_cast<Index>(node - &body.m_nodes[0]); };
  SoftFeatures features;
  std::vector<bool> is_of_face(static_cast<std::size_t>(body.m_nodes.size()));
  for (int i = 0; i < body.m_faces.size(); ++i) {
    const btSoftBody::Node* const* const nodes = body.m_faces[i].m_n;
    const Face& face = features.faces.emplace_back(Face{index(nodes[0]), index(nodes[1]), index(nodes[2])});
    for (const Index vertex : face) is_of_face[static_cast<std::size_t>(vertex)] = true;
  }
  for (int i = 0; i < body.m_links.size(); ++i) {
    const btSoftBody::Link& link = body.m_links[i];
    const Edge edge{index(link.m_n[0]), index(link.m_n[1])};
    const bool is_inside = std::ranges::all_of(edge, [&](Index v) { return is_of_face[static_cast<std::size_t>(v)]; });
    if (!link.m_bbending && !is_inside) features.edges.push_back(edge);
  }
  return features;
}

Mesh mesh_of(const btSoftBody& body) {
  const SoftFeatures features = features_of(body);
  return Mesh(body.m_nodes.size(), features.faces, features.edges);
}

namespace {

/// The fraction of each distance that is kept; Detector::truncate's default.
constexpr double kKept = 0.1;
/// How many further questions `way_towards` may ask.
constexpr int kFurtherQuestions = 3;

/// Returns positions on the way from start to end. If a contact stops some vertices early, one question lets all others
/// go only a quarter of an edge farther. Further questions let them go on; their gain counts if the straight way from
/// the start to there is free, too.
std::vector<Point> way_towards(Detector& detector, const std::vector<Point>& start, const std::vector<Point>& end) {
  const auto truncated = [&](const std::vector<Point>& from) {
    return detector.truncate({from, end}, kKept, {.at_start = AtStart::ignore}, StoredType::float32).positions;
  };
  const std::vector<Point> first = truncated(start);
  std::vector<Point> reached = first;
  for (int i = 0; i < kFurtherQuestions && reached != end; ++i) reached = truncated(reached);
  return reached == first || detector.is_free({start, reached}) ? reached : first;
}

}  // namespace

void TruncatedWorld::predictUnconstraintMotion(btScalar seconds) {
  starts_.clear();
  for (int i = 0; i < getSoftBodyArray().size(); ++i)
    starts_[getSoftBodyArray()[i]] = positions_of(*getSoftBodyArray()[i]);
  std::erase_if(asked_, [&](const auto& entry) { return !starts_.contains(entry.first); });
  held_back_ = 0;
  btDeformableMultiBodyDynamicsWorld::predictUnconstraintMotion(seconds);
}

void TruncatedWorld::integrateTransforms(btScalar seconds) {
  btDeformableMultiBodyDynamicsWorld::integrateTransforms(seconds);
  for (int i = 0; i < getSoftBodyArray().size(); ++i)
    truncate(*getSoftBodyArray()[i], starts_.at(getSoftBodyArray()[i]), seconds);
}

void TruncatedWorld::truncate(btSoftBody& body, const std::vector<Point>& start, btScalar seconds) {
  const std::vector<Point> end = positions_of(body);
  SoftFeatures features = features_of(body);
  if (features.faces.empty() && features.edges.empty()) return;
  auto asked = asked_.find(&body);
  if (asked == asked_.end() || asked->second.features != features)
    asked = asked_.insert_or_assign(&body, Asked{std::move(features), Detector(mesh_of(body), {.threads = 1})}).first;
  const std::vector<Point> reached = way_towards(asked->second.detector, start, end);
  for (std::size_t v = 0; v < end.size(); ++v) {
    if (reached[v] == end[v]) continue;
    btSoftBody::Node& node = body.m_nodes[static_cast<int>(v)];
    node.m_x = node.m_q = vector_of(reached[v]);
    node.m_v = node.m_vn = (node.m_x - vector_of(start[v])) / seconds;
    ++held_back_;
  }
}

}  // namespace tamis::bullet
