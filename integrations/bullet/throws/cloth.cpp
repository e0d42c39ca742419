#include "integrations/bullet/throws/cloth.hpp"

#include <BulletSoftBody/btDeformableBodySolver.h>
#include <BulletSoftBody/btDeformableGravityForce.h>
#include <BulletSoftBody/btDeformableMassSpringForce.h>
#include <BulletSoftBody/btDeformableMultiBodyConstraintSolver.h>
#include <BulletSoftBody/btSoftBodyHelpers.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <btBulletDynamicsCommon.h>

#include <ctime>
#include <memory>

#include "integrations/bullet/truncated_world.hpp"
#include "tamis/detector.hpp"

namespace tamis::bullet {
namespace {

constexpr btScalar kStep = 1.0F / 240;

/// The cloth that pybullet makes by loadSoftBody with springs of stiffness 40, bending springs of 0.1, and
/// self-collision.
class FallingCloth {
 public:
  FallingCloth(int side, bool truncated) {
    if (truncated)
      world_ = std::make_unique<TruncatedWorld>(&dispatcher_, &broadphase_, &solver_, &configuration_, &soft_solver_);
    else
      world_ = std::make_unique<btDeformableMultiBodyDynamicsWorld>(&dispatcher_, &broadphase_, &solver_,
                                                                    &configuration_, &soft_solver_);
    solver_.setDeformableSolver(&soft_solver_);
    const btVector3 gravity(0, 0, -10);
    world_->setGravity(gravity);
    world_->getWorldInfo().m_gravity = gravity;
    set_solver(world_->getSolverInfo());
    stand(ball_, {0.02F, 0.01F, 0.2F});
    stand(floor_, {0, 0, -0.1F});
    add_cloth(side);
    gravity_ = std::make_unique<btDeformableGravityForce>(gravity);
    world_->addForce(cloth_.get(), &springs_);
    world_->addForce(cloth_.get(), gravity_.get());
  }
  ~FallingCloth() {
    world_->removeSoftBody(cloth_.get());
    for (const auto& body : standing_) world_->removeRigidBody(body.get());
  }
  FallingCloth(const FallingCloth&) = delete;
  FallingCloth& operator=(const FallingCloth&) = delete;

  void step() { world_->stepSimulation(kStep, 1, kStep); }
  const btSoftBody& cloth() const { return *cloth_; }

 private:
  /// Sets pybullet's parameters in place of Bullet's defaults.
  static void set_solver(btContactSolverInfo& solver) {
    solver.m_erp2 = 0.08F;
    solver.m_frictionERP = 0.2F;
    solver.m_linearSlop = 1e-5F;
    solver.m_numIterations = 50;
    solver.m_minimumSolverBatchSize = 0;
    solver.m_warmstartingFactor = 0.1F;
    solver.m_leastSquaresResidualThreshold = 1e-7F;
  }

  void stand(btCollisionShape& shape, const btVector3& place) {
    btRigidBody::btRigidBodyConstructionInfo info(0, nullptr, &shape);
    info.m_startWorldTransform.setOrigin(place);
    standing_.push_back(std::make_unique<btRigidBody>(info));
    world_->addRigidBody(standing_.back().get());
  }

  void add_cloth(int side) {
    std::vector<btScalar> vertices;
    std::vector<int> triangles;
    const auto at = [&](int i) { return static_cast<btScalar>(i) / static_cast<btScalar>(side - 1) - 0.5F; };
    for (int i = 0; i < side; ++i)
      for (int j = 0; j < side; ++j) vertices.insert(vertices.end(), {at(i), at(j), 0.6F});
    for (int i = 0; i + 1 < side; ++i)
      for (int j = 0; j + 1 < side; ++j) {
        const int a = i * side + j;
        triangles.insert(triangles.end(), {a, a + side, a + 1, a + 1, a + side, a + side + 1});
      }
    cloth_.reset(btSoftBodyHelpers::CreateFromTriMesh(world_->getWorldInfo(), vertices.data(), triangles.data(),
                                                      static_cast<int>(triangles.size() / 3)));
    cloth_->getCollisionShape()->setMargin(0.003F);
    cloth_->generateBendingConstraints(2);
    cloth_->setTotalMass(0.5F);
    cloth_->m_cfg.collisions =
        btSoftBody::fCollision::SDF_RD | btSoftBody::fCollision::SDF_RDF | btSoftBody::fCollision::VF_DD;
    cloth_->m_cfg.kDF = 0.5F;
    cloth_->m_cfg.kKHR = cloth_->m_cfg.kCHR = 1;
    cloth_->setSelfCollision(true);
    cloth_->setSpringStiffness(0.5F);
    cloth_->initializeFaceTree();
    world_->addSoftBody(cloth_.get());
  }

  btSoftBodyRigidBodyCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btDeformableBodySolver soft_solver_;
  btDeformableMultiBodyConstraintSolver solver_;
  std::unique_ptr<btDeformableMultiBodyDynamicsWorld> world_;
  btSphereShape ball_{0.15F};
  btBoxShape floor_{{2, 2, 0.1F}};
  std::vector<std::unique_ptr<btRigidBody>> standing_;
  std::unique_ptr<btSoftBody> cloth_;
  btDeformableMassSpringForce springs_{40, 0.1F, false, 0.1F};
  std::unique_ptr<btDeformableGravityForce> gravity_;
};

}  // namespace

ClothRun run_cloth(int side, int steps, bool truncated) {
  FallingCloth scene(side, truncated);
  ClothRun run{mesh_of(scene.cloth()), {positions_of(scene.cloth())}};
  const std::clock_t begin = std::clock();
  for (int i = 0; i < steps; ++i) {
    scene.step();
    run.frames.push_back(positions_of(scene.cloth()));
  }
  run.milliseconds = 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC / steps;
  return run;
}

int touching_steps(const ClothRun& run) {
  Detector detector(run.mesh, {.threads = 1});
  int touching = 0;
  for (std::size_t step = 0; step + 1 < run.frames.size(); ++step)
    touching += !detector.is_free({run.frames[step], run.frames[step + 1]});
  return touching;
}

}  // namespace tamis::bullet
