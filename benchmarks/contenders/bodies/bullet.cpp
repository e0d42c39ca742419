// Bullet 3.24, as Debian builds it: its casts of convex bodies, in floats. zlib licence.
#include <BulletCollision/NarrowPhaseCollision/btContinuousConvexCollision.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkConvexCast.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btSubSimplexConvexCast.h>
#include <btBulletCollisionCommon.h>

#include <cmath>

#include "benchmarks/contenders/bodies/bodies.hpp"

namespace tamis::bench {
namespace {

btVector3 vector_of(const Point& p) {
  return {static_cast<btScalar>(p[0]), static_cast<btScalar>(p[1]), static_cast<btScalar>(p[2])};
}

enum class Cast { continuous, gjk, subsimplex };

class Bullet final : public BodyContender {
 public:
  explicit Bullet(Cast cast) : cast_(cast) {}

  std::string name() const override {
    return cast_ == Cast::continuous ? "Bullet btContinuousConvexCollision"
           : cast_ == Cast::gjk      ? "Bullet btGjkConvexCast"
                                     : "Bullet btSubsimplexConvexCast";
  }
  bool knows(const BodyScene& scene) const override {
    return scene.is_convex && (cast_ == Cast::continuous || !scene.turns);
  }

  void take(const MovingPair& pair, bool) override {
    pair_ = &pair;
    first_ = hull_of(pair.first);
    second_ = hull_of(pair.second);
  }

  double first_contact() override {
    simplex_.reset();
    const Ends first = ends_of(pair_->first), second = ends_of(pair_->second);
    btConvexCast::CastResult result;
    const bool touches = caster()->calcTimeOfImpact(first.from, first.to, second.from, second.to, result);
    return touches ? static_cast<double>(result.m_fraction) : kNever;
  }

 private:
  struct Ends {
    btTransform from, to;
  };

  /// The margin enlarges the body, so it is tiny. Without a margin, btGjkConvexCast misses most contacts.
  static std::unique_ptr<btConvexHullShape> hull_of(const MovingBody& body) {
    auto hull = std::make_unique<btConvexHullShape>();
    for (const Point& p : body.shape.points) hull->addPoint(vector_of(p), false);
    hull->setMargin(static_cast<btScalar>(1e-4));
    hull->recalcLocalAabb();
    return hull;
  }

  static Ends ends_of(const MovingBody& body) {
    const btVector3 turn = vector_of(body.turn);
    const btScalar angle = turn.length();
    const btQuaternion turned = angle > 0 ? btQuaternion(turn / angle, angle) : btQuaternion::getIdentity();
    return {btTransform(btQuaternion::getIdentity(), vector_of(body.from)), btTransform(turned, vector_of(body.to))};
  }

  std::unique_ptr<btConvexCast> caster() {
    if (cast_ == Cast::gjk) return std::make_unique<btGjkConvexCast>(first_.get(), second_.get(), &simplex_);
    if (cast_ == Cast::subsimplex)
      return std::make_unique<btSubsimplexConvexCast>(first_.get(), second_.get(), &simplex_);
    return std::make_unique<btContinuousConvexCollision>(first_.get(), second_.get(), &simplex_, &depth_);
  }

  Cast cast_;
  const MovingPair* pair_ = nullptr;
  std::unique_ptr<btConvexHullShape> first_, second_;
  btVoronoiSimplexSolver simplex_;
  btGjkEpaPenetrationDepthSolver depth_;
};

}  // namespace

void add_bullet(BodyContenders& list) {
  for (const Cast cast : {Cast::continuous, Cast::gjk, Cast::subsimplex})
    list.push_back(std::make_unique<Bullet>(cast));
}

}  // namespace tamis::bench
