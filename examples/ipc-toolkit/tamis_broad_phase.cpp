#include "tamis_broad_phase.hpp"

#include <stdexcept>
#include <tamis/from_matrix.hpp>

namespace ipc {

void TamisBroadPhase::build(Eigen::ConstRef<Eigen::MatrixXd> vertices, Eigen::ConstRef<Eigen::MatrixXi> edges,
                            Eigen::ConstRef<Eigen::MatrixXi> faces, const double inflation_radius) {
  clear();
  pose_ = tamis::points_of(vertices);
  take_mesh(vertices.rows(), edges, faces);
  for (const auto& pair : detector_->pairs_within(pose_, 2 * inflation_radius)) keep(pair.kind, pair.vertices);
}

void TamisBroadPhase::build(Eigen::ConstRef<Eigen::MatrixXd> vertices_t0, Eigen::ConstRef<Eigen::MatrixXd> vertices_t1,
                            Eigen::ConstRef<Eigen::MatrixXi> edges, Eigen::ConstRef<Eigen::MatrixXi> faces,
                            const double inflation_radius) {
  clear();
  const auto start = tamis::points_of(vertices_t0), end = tamis::points_of(vertices_t1);
  take_mesh(vertices_t0.rows(), edges, faces);
  tamis::QueryOptions options;
  options.min_separation = 2 * inflation_radius;
  for (const auto& contact : detector_->contacts({start, end}, options)) keep(contact.kind, contact.vertices);
}

void TamisBroadPhase::build(const AABBs&, Eigen::ConstRef<Eigen::MatrixXi>, Eigen::ConstRef<Eigen::MatrixXi>, uint8_t) {
  throw std::runtime_error("TamisBroadPhase: boxes alone have no distances: give the positions of the vertices");
}

void TamisBroadPhase::clear() {
  BroadPhase::clear();
  dim = 3;
  for (auto& pairs : found_) pairs.clear();
  pose_.clear();
}

void TamisBroadPhase::take_mesh(std::ptrdiff_t vertex_count, Eigen::ConstRef<Eigen::MatrixXi> edges,
                                Eigen::ConstRef<Eigen::MatrixXi> faces) {
  const auto same = [](const Eigen::MatrixXi& a, const auto& b) {
    return a.rows() == b.rows() && a.cols() == b.cols() && a == b;
  };
  if (detector_ && detector_->mesh().vertex_count() == vertex_count && same(edges_, edges) && same(faces_, faces))
    return;
  edges_ = edges;
  faces_ = faces;
  std::vector<bool> is_used(static_cast<std::size_t>(vertex_count));
  for (const auto* rows : {&edges_, &faces_})
    for (const int vertex : rows->reshaped()) is_used[static_cast<std::size_t>(vertex)] = true;
  std::vector<tamis::Index> loose;
  for (std::size_t i = 0; i < is_used.size(); ++i)
    if (!is_used[i]) loose.push_back(static_cast<tamis::Index>(i));
  // An empty matrix has no columns.
  const auto listed = faces_.size() ? tamis::faces_of(faces_) : std::vector<tamis::Face>();
  const auto rods = edges_.size() ? tamis::edges_of(edges_) : std::vector<tamis::Edge>();
  const tamis::Mesh mesh(static_cast<tamis::Index>(vertex_count), listed, rods, loose);
  given_.assign(mesh.edges().size(), -1);
  for (int i = 0; i < edges_.rows(); ++i)
    if (const auto edge = mesh.find_edge(edges_(i, 0), edges_(i, 1)); edge >= 0)
      given_[static_cast<std::size_t>(edge)] = i;
  detector_ = std::make_unique<tamis::Detector>(mesh);
}

// A pair counts if any two of its vertices may collide, as in ipc-toolkit's own broad phases.
void TamisBroadPhase::keep(tamis::PairKind kind, const Vertices& vertices) {
  const auto first = kind == tamis::PairKind::edge_edge ? 2 : 1;
  for (auto i = 0; i < first; ++i)
    for (auto j = first; j < 4 && vertices[static_cast<std::size_t>(j)] >= 0; ++j)
      if (can_vertices_collide(static_cast<std::size_t>(vertices[static_cast<std::size_t>(i)]),
                               static_cast<std::size_t>(vertices[static_cast<std::size_t>(j)])))
        return found_[static_cast<std::size_t>(kind)].push_back(vertices);
}

int TamisBroadPhase::edge_at(int a, int b) const {
  return given_[static_cast<std::size_t>(detector_->mesh().find_edge(a, b))];
}

void TamisBroadPhase::detect_vertex_vertex_candidates(std::vector<VertexVertexCandidate>& candidates) const {
  for (const auto& [a, b, _, __] : found(tamis::PairKind::vertex_vertex)) candidates.emplace_back(a, b);
}

void TamisBroadPhase::detect_edge_vertex_candidates(std::vector<EdgeVertexCandidate>& candidates) const {
  for (const auto& [p, a, b, _] : found(tamis::PairKind::vertex_edge)) candidates.emplace_back(edge_at(a, b), p);
}

void TamisBroadPhase::detect_edge_edge_candidates(std::vector<EdgeEdgeCandidate>& candidates) const {
  for (const auto& [a0, a1, b0, b1] : found(tamis::PairKind::edge_edge))
    candidates.emplace_back(edge_at(a0, a1), edge_at(b0, b1));
}

void TamisBroadPhase::detect_face_vertex_candidates(std::vector<FaceVertexCandidate>& candidates) const {
  for (const auto& [p, a, b, c] : found(tamis::PairKind::vertex_face))
    candidates.emplace_back(detector_->mesh().find_face({a, b, c}), p);
}

// Of one pose: the edges that pass through triangles.
void TamisBroadPhase::detect_edge_face_candidates(std::vector<EdgeFaceCandidate>& candidates) const {
  if (pose_.empty())
    throw std::runtime_error("TamisBroadPhase: edge-face candidates are those of one pose: build it with one");
  for (const auto& [edge, face, s_lower, s_upper, u, v] : detector_->intersections(pose_)) {
    bool may = false;
    for (const int a : edge)
      for (const int b : face)
        may = may || can_vertices_collide(static_cast<std::size_t>(a), static_cast<std::size_t>(b));
    if (may) candidates.emplace_back(edge_at(edge[0], edge[1]), detector_->mesh().find_face(face));
  }
}

void TamisBroadPhase::detect_face_face_candidates(std::vector<FaceFaceCandidate>&) const {
  throw std::runtime_error(
      "TamisBroadPhase: it has no face-face candidates: use edge-face candidates, or another broad phase");
}

}  // namespace ipc
