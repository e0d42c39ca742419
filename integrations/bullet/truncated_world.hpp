// A Bullet world whose soft bodies do not pass through themselves.
#pragma once
#include <BulletSoftBody/btDeformableMultiBodyDynamicsWorld.h>

#include <map>
#include <vector>

#include "tamis/detector.hpp"

namespace tamis::bullet {

/// The triangles of a soft body, and its links with at least one end in no triangle: ropes. Bending links do not count.
struct SoftFeatures {
  std::vector<Face> faces;
  std::vector<Edge> edges;
  bool operator==(const SoftFeatures&) const = default;
};
SoftFeatures features_of(const btSoftBody& body);

/// Use it in place of btDeformableMultiBodyDynamicsWorld; all else stays as it is. After Bullet has moved the vertices
/// of a soft body, each is put at its position from Detector::truncate: on the straight ways there no two features of
/// that body touch. A vertex that is held back loses the speed that it could not use. Bullet's repulsion stays, and
/// keeps layers apart; contacts that it misses are stopped here. Bullet alone handles a soft body against another one
/// and against rigid bodies.
class TruncatedWorld : public btDeformableMultiBodyDynamicsWorld {
 public:
  BT_DECLARE_ALIGNED_ALLOCATOR();
  using btDeformableMultiBodyDynamicsWorld::btDeformableMultiBodyDynamicsWorld;

  /// How many vertices were held back in the last step.
  int held_back() const { return held_back_; }

 protected:
  /// The first part of a step. It runs after the callback before the step, which may have added bodies.
  void predictUnconstraintMotion(btScalar seconds) override;
  void integrateTransforms(btScalar seconds) override;

 private:
  void truncate(btSoftBody& body, const std::vector<Point>& start, btScalar seconds);

  struct Asked {
    SoftFeatures features;
    Detector detector;
  };
  std::map<const btSoftBody*, Asked> asked_;
  std::map<const btSoftBody*, std::vector<Point>> starts_;
  int held_back_ = 0;
};

/// The positions of a body's vertices, in the order of Bullet's nodes.
std::vector<Point> positions_of(const btSoftBody& body);
Mesh mesh_of(const btSoftBody& body);

}  // namespace tamis::bullet
