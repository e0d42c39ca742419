// A Bullet world whose soft bodies do not pass through themselves.
#pragma once
#include <BulletSoftBody/btDeformableMultiBodyDynamicsWorld.h>

#include <map>
#include <vector>

#include "tamis/detector.hpp"

namespace tamis::bullet {

/// Triangles, and links that lead to no triangle at one end at least: ropes. Bending links are none.
struct SoftFeatures {
  std::vector<Face> faces;
  std::vector<Edge> edges;
  bool operator==(const SoftFeatures&) const = default;
};
SoftFeatures features_of(const btSoftBody& body);

/// Use it in place of btDeformableMultiBodyDynamicsWorld; all else stays as it is. After Bullet has moved the vertices
/// of a soft body, they are put where Detector::truncate says: on their straight ways there no two features of that
/// body touch. Who is held back loses the speed that it could not use. Bullet's repulsion stays, and keeps the layers
/// apart; what it misses is stopped here. A soft body against another, and against rigid ones, is Bullet's.
class TruncatedWorld : public btDeformableMultiBodyDynamicsWorld {
 public:
  BT_DECLARE_ALIGNED_ALLOCATOR();
  using btDeformableMultiBodyDynamicsWorld::btDeformableMultiBodyDynamicsWorld;

  /// Of the last step: vertices that were held back.
  int held_back() const { return held_back_; }

 protected:
  /// The first part of a step: after the callback before it, which may have added bodies.
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

/// Where its vertices are, in the order of Bullet's nodes.
std::vector<Point> positions_of(const btSoftBody& body);
Mesh mesh_of(const btSoftBody& body);

}  // namespace tamis::bullet
