// A Bullet world in which no body passes through another.
#pragma once
#include <btBulletDynamicsCommon.h>

#include <map>
#include <memory>
#include <vector>

#include "integrations/bullet/solver_contacts.hpp"
#include "integrations/clamp.hpp"

namespace tamis::bullet {

/// Use it in place of btDiscreteDynamicsWorld; all else stays as it is. Rigid bodies of any kind and fixed collision
/// objects take part, each with the mesh of its shape (`mesh_of`).
///
/// Bodies are held back (integrations/clamp.hpp) in integrateTransforms, the last part of Bullet's step, which decides
/// how each body moves. The tick callback comes too late: bodies have moved by then, and islands may have gone to
/// sleep.
///
/// Bullet's own narrow phase does not see every contact of meshes, and sees those of boxes only once they overlap;
/// bodies would be held back for ever and gather speed. So two kinds of predictive contacts are added, at which the
/// solver keeps bodies one gap apart: pairs within two gaps, and the contacts that held bodies back in the last step (a
/// plate that spins on its edge comes down on another one). The clamp takes the speed that the solver leaves. So bodies
/// that lie on each other are held back only while they come near.
class ClampedWorld : public btDiscreteDynamicsWorld {
 public:
  BT_DECLARE_ALIGNED_ALLOCATOR();

  /// As the constructor of btDiscreteDynamicsWorld. `threads`: as Options::threads.
  ClampedWorld(btDispatcher* dispatcher, btBroadphaseInterface* broadphase, btConstraintSolver* solver,
               btCollisionConfiguration* configuration, adapters::ClampOptions options = {}, int threads = 1);

  /// Gives a mesh to a shape that has none, or replaces its own: for bodies that have the shape already, and for those
  /// added later. Call it again when the shape is changed (`traits_of`).
  void set_mesh(const btCollisionShape& shape, const Shape& mesh);

  /// Throws InvalidMesh if a shape has no mesh; then the object is not added.
  void addCollisionObject(btCollisionObject* object, int group = btBroadphaseProxy::StaticFilter,
                          int mask = btBroadphaseProxy::AllFilter ^ btBroadphaseProxy::StaticFilter) override;
  void removeCollisionObject(btCollisionObject* object) override;
  void removeRigidBody(btRigidBody* body) override;
  void performDiscreteCollisionDetection() override;

  /// The last step: bodies that wanted to move, in the order of their numbers, and which part of its way each went.
  struct LastStep {
    std::vector<std::pair<const btRigidBody*, double>> moved;
    int questions = 0;            ///< as in ClampedStep
    std::size_t overlapping = 0;  ///< pairs of bodies that overlapped when it began
  };
  const LastStep& last_step() const { return last_step_; }

 protected:
  void createPredictiveContacts(btScalar seconds) override;
  void integrateTransforms(btScalar seconds) override;

 private:
  /// The mesh that bodies of one shape share.
  struct Surface {
    explicit Surface(const Shape& shape);

    Shape mesh;
    double radius;  ///< the largest distance of its points from the origin
  };
  /// A shape as it was when its mesh was made.
  struct KnownShape {
    const btCollisionShape* shape;
    std::vector<btScalar> traits;
    std::shared_ptr<const Surface> surface;
  };
  struct Member {
    btCollisionObject* object;
    KnownShape shape;
    btTransform place;  ///< where `bodies_` has it
    Pose pose;          ///< the same
    bool is_active;     ///< as `bodies_` has it: a body that sleeps is Static there, and costs nothing
  };
  class Way;
  class Step;

  /// A body that stands or sleeps is static.
  static BodyMotion motion_at(const btCollisionObject& object, const Pose& pose);
  void join(btCollisionObject* object, const KnownShape& shape);
  void leave(const btCollisionObject* object);
  /// With another mesh.
  void take_anew(btCollisionObject* object, const KnownShape& shape);
  KnownShape known(const btCollisionShape* shape) const;
  /// Says where the object is if its shape is refused.
  KnownShape known_of(const btCollisionObject& object) const;
  void put(BodyId id, Member& member);
  /// Forgets what held the body back in the last step: it was moved from outside.
  void forget_limits_of(BodyId id);
  void follow();
  /// The clamp leaves out contacts of bodies that overlap; where they lie flat on each other and turn, those are the
  /// dearest of all, so they are not asked about.
  void set_overlapping_may_touch(bool may_touch);

  adapters::ClampOptions options_;
  World bodies_;
  std::map<BodyId, Member> members_;
  std::map<const btCollisionShape*, KnownShape> given_;  ///< by set_mesh
  adapters::Beginning beginning_;                        ///< of this step
  std::vector<BodyContact> limits_;                      ///< of the last step
  bool are_apart_ = false;                               ///< where the last step ended, and nothing has changed since
  bool all_collide_ = true;                              ///< when this step begins, of all that are near or overlap
  LastStep last_step_;
};

}  // namespace tamis::bullet
