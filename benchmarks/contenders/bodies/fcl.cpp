// FCL 0.7, as Debian builds it: conservative advancement, of convex bodies and of meshes, in doubles. BSD licence.
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/math/motion/interp_motion.h>
#include <fcl/narrowphase/continuous_collision.h>

#include <cmath>

#include "benchmarks/contenders/bodies/bodies.hpp"

namespace tamis::bench {
namespace {

fcl::Vector3d eigen_of(const Point& p) { return {p[0], p[1], p[2]}; }

std::shared_ptr<fcl::CollisionGeometryd> convex_of(const scenes::Shape& shape) {
  auto points = std::make_shared<std::vector<fcl::Vector3d>>();
  for (const Point& p : shape.points) points->push_back(eigen_of(p));
  auto faces = std::make_shared<std::vector<int>>();
  for (const Face& f : shape.faces) faces->insert(faces->end(), {3, f[0], f[1], f[2]});
  auto convex = std::make_shared<fcl::Convexd>(points, static_cast<int>(shape.faces.size()), faces);
  convex->computeLocalAABB();
  return convex;
}

std::shared_ptr<fcl::CollisionGeometryd> mesh_of(const scenes::Shape& shape) {
  std::vector<fcl::Vector3d> points;
  for (const Point& p : shape.points) points.push_back(eigen_of(p));
  std::vector<fcl::Triangle> faces;
  for (const Face& f : shape.faces)
    faces.emplace_back(static_cast<std::size_t>(f[0]), static_cast<std::size_t>(f[1]), static_cast<std::size_t>(f[2]));
  auto mesh = std::make_shared<fcl::BVHModel<fcl::RSSd>>();
  mesh->beginModel();
  mesh->addSubModel(points, faces);
  mesh->endModel();
  mesh->computeLocalAABB();
  return mesh;
}

class Fcl final : public BodyContender {
 public:
  std::string name() const override { return "FCL conservative advancement"; }
  bool knows(const BodyScene&) const override { return true; }

  void take(const MovingPair& pair, bool is_convex) override {
    pair_ = &pair;
    const auto make = is_convex ? convex_of : mesh_of;
    first_ = make(pair.first.shape);
    second_ = make(pair.second.shape);
  }

  double first_contact() override {
    const auto first = motion_of(pair_->first), second = motion_of(pair_->second);
    const fcl::ContinuousCollisionRequestd request(1000, 1e-6, fcl::CCDM_LINEAR, fcl::GST_LIBCCD,
                                                   fcl::CCDC_CONSERVATIVE_ADVANCEMENT);
    fcl::ContinuousCollisionResultd result;
    fcl::continuousCollide(first_.get(), &first, second_.get(), &second, request, result);
    return result.is_collide ? result.time_of_contact : kNever;
  }

 private:
  static fcl::InterpMotion<double> motion_of(const MovingBody& body) {
    const fcl::Vector3d turn = eigen_of(body.turn);
    const double angle = turn.norm();
    fcl::Matrix3d turned = fcl::Matrix3d::Identity();
    if (angle > 0) turned = fcl::AngleAxisd(angle, turn / angle).toRotationMatrix();
    return {fcl::Matrix3d::Identity(), eigen_of(body.from), turned, eigen_of(body.to), fcl::Vector3d::Zero()};
  }

  const MovingPair* pair_ = nullptr;
  std::shared_ptr<fcl::CollisionGeometryd> first_, second_;
};

}  // namespace

void add_fcl(BodyContenders& list) { list.push_back(std::make_unique<Fcl>()); }

}  // namespace tamis::bench
