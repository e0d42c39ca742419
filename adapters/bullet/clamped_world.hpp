// A Bullet world in which no body passes through another.
#pragma once
#include <btBulletDynamicsCommon.h>

#include <map>
#include <memory>
#include <vector>

#include "adapters/bullet/near_contacts.hpp"
#include "adapters/clamp.hpp"

namespace tamis::bullet {

/// Use it in place of btDiscreteDynamicsWorld; all else stays as it is. Rigid bodies of any kind take part, and fixed
/// collision objects, each with the mesh of its shape (`mesh_of`).
///
/// The last part of Bullet's step, integrateTransforms, is where it says how each body is to move; there bodies are
/// held back (adapters/clamp.hpp). The tick callback comes too late, when bodies are already elsewhere and islands may
/// have gone to sleep. Bullet's own narrow phase does not see every contact of meshes, and boxes only once they
/// overlap, so that bodies would be held back for ever and gather speed. Two kinds of predictive contacts are therefore
/// added, on which the solver keeps bodies one gap apart: pairs within two gaps, and what held bodies back in the last
/// step (a plate that spins on its edge comes down on another one). What the solver has not solved of the former is
/// taken from the bodies after it (Carriers). So bodies that lie on each other are held back only while they come near.
class ClampedWorld : public btDiscreteDynamicsWorld {
 public:
  BT_DECLARE_ALIGNED_ALLOCATOR();

  /// As btDiscreteDynamicsWorld's. `threads`: as Options::threads.
  ClampedWorld(btDispatcher* dispatcher, btBroadphaseInterface* broadphase, btConstraintSolver* solver,
               btCollisionConfiguration* configuration, adapters::ClampOptions options = {}, int threads = 1);

  /// The mesh of a shape that has none of its own, or another than its own: for bodies that have it, and that are added
  /// with it. Again where the shape is changed (`traits_of`).
  void set_mesh(const btCollisionShape& shape, const Shape& mesh);

  /// Throw InvalidMesh where a shape has no mesh; the object is not added then.
  void addCollisionObject(btCollisionObject* object, int group = btBroadphaseProxy::StaticFilter,
                          int mask = btBroadphaseProxy::AllFilter ^ btBroadphaseProxy::StaticFilter) override;
  void removeCollisionObject(btCollisionObject* object) override;
  void removeRigidBody(btRigidBody* body) override;

  /// Of the last step: bodies in the order of their numbers, and which part of its way each that wanted to move went.
  struct LastStep {
    std::vector<std::pair<const btRigidBody*, double>> moved;
    int questions = 0;            ///< as in ClampedStep
    std::size_t overlapping = 0;  ///< pairs of bodies that overlapped when it began
  };
  const LastStep& last_step() const { return last_step_; }

 protected:
  void createPredictiveContacts(btScalar seconds) override;
  void performDiscreteCollisionDetection() override;
  void integrateTransforms(btScalar seconds) override;

 private:
  /// A shape as it was when its mesh was made.
  struct KnownShape {
    const btCollisionShape* shape;
    std::vector<btScalar> traits;
    std::shared_ptr<const Surface> surface;
  };
  struct Member {
    btCollisionObject* object;
    KnownShape shape;
    btTransform place;  ///< where the world of bodies has it
    bool is_active;     ///< as the world of bodies has it: what sleeps is Static there, and costs nothing
  };
  class Way;
  class Step;

  void join(btCollisionObject* object, const KnownShape& shape);
  void leave(const btCollisionObject* object);
  /// With another mesh.
  void take_anew(btCollisionObject* object, const KnownShape& shape);
  KnownShape known(const btCollisionShape* shape) const;
  void put(BodyId id, Member& member);
  /// Forgets what held the body back in the last step: it was moved from outside.
  void forget_limits_of(BodyId id);
  void follow();
  bool collides(const adapters::BodyPair& bodies) const;
  NearFeature feature_of(BodyId body, std::span<const Index> vertices, std::span<const double> weights,
                         double sign) const;
  /// `is_now`: near where the bodies are; otherwise on their ways of the last step.
  template <class Pair>
  void find_near(const Pair& pair, const Point& direction, bool is_now, SolverContacts& for_solver);

  adapters::ClampOptions options_;
  World bodies_;
  std::map<BodyId, Member> members_;
  std::map<const btCollisionShape*, KnownShape> given_;  ///< by set_mesh
  std::set<adapters::BodyPair> overlapping_;
  std::vector<BodyContact> limits_;                 ///< of the last step
  std::vector<NearContact> near_;                   ///< when this step began
  std::map<adapters::BodyPair, double> distances_;  ///< then, of these and of near pairs that push sidewards
  LastStep last_step_;
};

}  // namespace tamis::bullet
