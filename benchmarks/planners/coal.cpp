// Sampled checks by coal, with its trees of oriented boxes around triangles, and a tree of the obstacles' boxes.
#include <cmath>
#include <ctime>
#include <memory>

#include "planners/scene.hpp"
#ifdef TAMIS_HAS_COAL
#include <coal/BVH/BVH_model.h>
#include <coal/broadphase/broadphase_dynamic_AABB_tree.h>
#include <coal/broadphase/default_broadphase_callbacks.h>
#include <coal/collision.h>
#endif

namespace tamis::planners {

#ifdef TAMIS_HAS_COAL
namespace {

using Model = coal::BVHModel<coal::OBBRSS>;

std::shared_ptr<Model> model_of(const scenes::Shape& shape) {
  auto model = std::make_shared<Model>();
  std::vector<coal::Vec3s> points;
  std::vector<coal::Triangle> triangles;
  for (const Point& p : shape.points) points.emplace_back(p[0], p[1], p[2]);
  for (const Face& face : shape.faces)
    triangles.emplace_back(static_cast<std::size_t>(face[0]), static_cast<std::size_t>(face[1]),
                           static_cast<std::size_t>(face[2]));
  model->beginModel(static_cast<unsigned>(triangles.size()), static_cast<unsigned>(points.size()));
  model->addSubModel(points, triangles);
  model->endModel();
  model->computeLocalAABB();
  return model;
}

class Sampler {
 public:
  explicit Sampler(const Scene& scene) : scene_(scene) {
    for (const scenes::Shape& link : scene.links)
      links_.push_back(std::make_unique<coal::CollisionObject>(model_of(link)));
    for (const scenes::Shape& shape : scene.obstacles) {
      obstacles_.push_back(std::make_unique<coal::CollisionObject>(model_of(shape)));
      obstacles_.back()->computeAABB();
      tree_.registerObject(obstacles_.back().get());
    }
    tree_.setup();
  }

  bool collides(const double* start, const double* end, double time) {
    coal::Transform3s place = coal::Transform3s::Identity();
    for (std::size_t k = 0; k < links_.size(); ++k) {
      const Joint& joint = scene_.joints[k];
      const double angle = (1 - time) * start[k] + time * end[k];
      const Eigen::AngleAxisd turn(angle, Eigen::Vector3d(joint.axis[0], joint.axis[1], joint.axis[2]));
      const auto& shift = joint.place.position;
      place = place * coal::Transform3s(turn.toRotationMatrix(), coal::Vec3s(shift[0], shift[1], shift[2]));
      links_[k]->setTransform(place);
      links_[k]->computeAABB();
    }
    for (std::size_t k = links_.size(); k-- > 0;) {
      coal::CollisionCallBackDefault found;
      tree_.collide(links_[k].get(), &found);
      if (found.data.result.isCollision()) return true;
    }
    for (const auto& [a, b] : scene_.self_pairs) {
      if (!links_[a]->getAABB().overlap(links_[b]->getAABB())) continue;
      coal::CollisionResult result;
      if (coal::collide(links_[a].get(), links_[b].get(), request_, result) > 0) return true;
    }
    return false;
  }

 private:
  const Scene& scene_;
  coal::CollisionRequest request_;
  std::vector<std::unique_ptr<coal::CollisionObject>> links_, obstacles_;
  coal::DynamicAABBTreeCollisionManager tree_;
};

/// The numbers 1 to count, in the order of bisection.
std::vector<int> bisected(int count) {
  std::vector<int> order{count};
  std::vector<std::array<int, 2>> parts{{1, count - 1}};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto [low, high] = parts[i];
    if (low > high) continue;
    const int middle = (low + high) / 2;
    order.push_back(middle);
    parts.push_back({low, middle - 1});
    parts.push_back({middle + 1, high});
  }
  return order;
}

}  // namespace

std::vector<Answer> sampled(const Scene& scene, const Edges& edges, const std::vector<int>& states) {
  Sampler sampler(scene);
  std::vector<Answer> answers;
  for (const int count : states) {
    Answer answer{"coal, " + std::to_string(count) + " states", {}, 0};
    const std::vector<int> order = bisected(count);
    const std::clock_t begin = std::clock();
    for (std::size_t i = 0; i < edges.count(); ++i) {
      const double *start = &edges.starts[i * kAxes], *end = &edges.ends[i * kAxes];
      bool collides = sampler.collides(start, end, 0);
      for (std::size_t k = 0; k < order.size() && !collides; ++k)
        collides = sampler.collides(start, end, order[k] / double(count));
      answer.is_free.push_back(!collides);
    }
    answer.seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    answers.push_back(std::move(answer));
  }
  return answers;
}
#else
std::vector<Answer> sampled(const Scene&, const Edges&, const std::vector<int>&) { return {}; }
#endif

}  // namespace tamis::planners
