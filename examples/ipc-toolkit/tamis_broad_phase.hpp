// Tamis as a broad phase of ipc-toolkit. Its candidates are decided, so there are few: pairs that come within twice the
// inflation radius during the step, or are that near in one pose. All other pairs are proven farther apart.
#pragma once
#include <ipc/broad_phase/broad_phase.hpp>
#include <memory>
#include <tamis/detector.hpp>

namespace ipc {

/// Keeps its detector as long as edges and faces stay the same. Three dimensions only. Face-face candidates are
/// refused: no call of ipc-toolkit's own wants them for collisions.
class TamisBroadPhase : public BroadPhase {
 public:
  std::string name() const override { return "Tamis"; }

  void build(Eigen::ConstRef<Eigen::MatrixXd> vertices, Eigen::ConstRef<Eigen::MatrixXi> edges,
             Eigen::ConstRef<Eigen::MatrixXi> faces, double inflation_radius = 0) override;
  void build(Eigen::ConstRef<Eigen::MatrixXd> vertices_t0, Eigen::ConstRef<Eigen::MatrixXd> vertices_t1,
             Eigen::ConstRef<Eigen::MatrixXi> edges, Eigen::ConstRef<Eigen::MatrixXi> faces,
             double inflation_radius = 0) override;
  void build(const AABBs& vertex_boxes, Eigen::ConstRef<Eigen::MatrixXi> edges, Eigen::ConstRef<Eigen::MatrixXi> faces,
             uint8_t dim) override;
  void clear() override;

  void detect_vertex_vertex_candidates(std::vector<VertexVertexCandidate>& candidates) const override;
  void detect_edge_vertex_candidates(std::vector<EdgeVertexCandidate>& candidates) const override;
  void detect_edge_edge_candidates(std::vector<EdgeEdgeCandidate>& candidates) const override;
  void detect_face_vertex_candidates(std::vector<FaceVertexCandidate>& candidates) const override;
  void detect_edge_face_candidates(std::vector<EdgeFaceCandidate>& candidates) const override;
  void detect_face_face_candidates(std::vector<FaceFaceCandidate>& candidates) const override;

 private:
  using Vertices = std::array<tamis::Index, 4>;

  void take_mesh(std::ptrdiff_t vertex_count, Eigen::ConstRef<Eigen::MatrixXi> edges,
                 Eigen::ConstRef<Eigen::MatrixXi> faces);
  void keep(tamis::PairKind kind, const Vertices& vertices);
  int edge_at(int a, int b) const;
  const std::vector<Vertices>& found(tamis::PairKind kind) const { return found_[static_cast<std::size_t>(kind)]; }

  Eigen::MatrixXi edges_, faces_;
  std::vector<int> given_;  // for each edge of the detector's mesh its row of edges_
  std::unique_ptr<tamis::Detector> detector_;
  std::array<std::vector<Vertices>, tamis::kPairKinds> found_;
  std::vector<tamis::Point> pose_;  // of intersections
};

}  // namespace ipc
