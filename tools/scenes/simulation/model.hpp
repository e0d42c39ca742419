// The model that is simulated: bodies, their materials, and the rules of the scene.
#pragma once
#include <vector>

#include "scenes/simulation/distance.hpp"
#include "scenes/simulation/gas.hpp"
#include "scenes/simulation/linear.hpp"
#include "scenes/simulation/obstacle.hpp"
#include "scenes/simulation/surface.hpp"
#include "scenes/simulation/tetrahedron.hpp"
#include "tamis/mesh.hpp"
#include "tamis/options.hpp"

namespace tamis::simulation {

struct Fabric {
  double density;  ///< kg per square metre
  double stretch;  ///< newton per metre, of each edge
  double bend;     ///< newton metre; 0: none
};

struct Solid {
  double density;  ///< kg per cubic metre
  Elasticity elasticity;
  Fabric skin;  ///< its density is that of the embedded surface
};

struct Model {
  Particles particles;  ///< first the vertices of the mesh, then nodes that carry embedded surfaces
  std::vector<Face> faces;
  std::vector<Index> object_of_vertex;  ///< of each vertex of the mesh
  std::vector<bool> is_obstacle;        ///< of each object

  std::vector<Distance> tethers;  ///< from the longest to the shortest
  std::vector<Distance> distances;
  std::vector<Bend> bends;
  std::vector<Attachment> attachments;
  std::vector<Tetrahedron> tetrahedra;
  std::vector<Gas> gases;
  std::vector<Obstacle> obstacles;

  Vec gravity{0, 0, -9.81};  ///< metres per second squared
  double thickness = 0.002;  ///< gap that repulsion keeps between surfaces, metres
  double friction = 0.3;     ///< Coulomb's coefficient
  double drag = 0.5;         ///< share of the speed lost to the air in a second
  double frame_time = 1.0 / 30;
  int substeps = 10;   ///< in a frame; more where a substep cannot be proven free
  int iterations = 8;  ///< of the constraint solver in a substep

  /// Vertices of the mesh, recorded and kept free of contacts.
  Index mesh_vertices() const { return static_cast<Index>(object_of_vertex.size()); }
  Mesh mesh() const { return Mesh(mesh_vertices(), faces); }
  /// Obstacles may pass through each other and through themselves.
  PairFilter pair_filter() const { return PairFilter::no_static_pairs(object_of_vertex, is_obstacle); }

  /// Each adds an object and returns its first vertex. Add a solid last: all vertices of the mesh come before the nodes
  /// of solids.
  Index add_obstacle(const Surface& surface, Obstacle::Path path);
  /// `sheet`: the same surface as cut from the cloth: flat and convex. Hinges folded there (seams) resist no bending.
  Index add_cloth(const Surface& surface, const Surface& sheet, const Fabric& fabric);
  /// A closed surface (small holes are fine) embedded in a lattice of tetrahedra with `cells` along its longest side.
  Index add_solid(const Surface& surface, const Solid& solid, Index cells);

 private:
  Index add_particles(const std::vector<Vec>& points);
  Index add_object(const Surface& surface, bool as_obstacle);
  /// `first`: the vertex of the mesh that is `sheet`'s point 0.
  void add_fabric(Index first, const Surface& sheet, const Fabric& fabric);
  void add_tethers(Index first, const Surface& sheet);
};

}  // namespace tamis::simulation
