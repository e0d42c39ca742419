// A Bullet world with one fixed mesh and one flying body, simulated by any of Bullet's methods or clamped.
#pragma once
#include <btBulletDynamicsCommon.h>

#include <memory>
#include <string_view>
#include <vector>

#include "tamis/mesh.hpp"
#include "tamis/step.hpp"

namespace tamis::bullet {

struct Triangles {
  std::vector<Point> points;
  std::vector<Face> faces;
};

/// places[i][b]: the transform of body b at time i.
using Places = std::vector<std::vector<btTransform>>;

/// A box around the origin.
Triangles box(const Point& half_extents);
/// cells x cells squares of two triangles each, at z = 0 around the origin.
Triangles wall(int cells, double half_side);

/// The shape of the flying body, and what stops it.
enum class Method { hull, hull_ccd, mesh, clamped_hull, clamped_mesh };
std::string_view name_of(Method method);

/// How the body is thrown, and the steps that are simulated.
struct Throw {
  Point position, velocity, spin;  ///< m, m/s, rad/s
  int steps;
  double seconds;        ///< of each step
  bool on_axle = false;  ///< the body can only turn about z
};

struct Flight {
  std::vector<btTransform> places;  ///< steps + 1
  double milliseconds = 0;          ///< processor time of all steps
};

/// The fixed mesh and the flying body. No gravity; the mass is 1.
class Arena {
 public:
  Arena(Triangles fixed, Triangles flying, double swept_radius);
  ~Arena();

  Flight fly(Method method, const Throw& thrown) const;

  const Triangles& fixed() const { return fixed_; }
  const Triangles& flying() const { return flying_; }

 private:
  std::unique_ptr<btCollisionShape> shape_for(Method method) const;

  Triangles fixed_, flying_;
  double swept_radius_;
  std::unique_ptr<btTriangleMesh> fixed_triangles_, flying_triangles_;
  std::unique_ptr<btBvhTriangleMeshShape> fixed_shape_;
};

}  // namespace tamis::bullet
