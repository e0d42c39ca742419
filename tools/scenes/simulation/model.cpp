#include "scenes/simulation/model.hpp"

#include "scenes/simulation/lattice.hpp"

namespace tamis::simulation {

Index Model::add_particles(const std::vector<Vec>& points) {
  const Index first = particles.count();
  const Eigen::Index count = first + static_cast<Eigen::Index>(points.size());
  particles.position.conservativeResize(3, count);
  particles.position.rightCols(count - first) = as_points(points);
  particles.velocity.setZero(3, count);
  particles.inverse_mass.conservativeResize(count);
  particles.inverse_mass.tail(count - first).setZero();
  return first;
}

Index Model::add_object(const Surface& surface, bool as_obstacle) {
  const Index first = add_particles(surface.points);
  const auto object = static_cast<Index>(is_obstacle.size());
  is_obstacle.push_back(as_obstacle);
  object_of_vertex.resize(static_cast<std::size_t>(particles.count()), object);
  for (const Face& f : surface.faces) faces.push_back({first + f[0], first + f[1], first + f[2]});
  return first;
}

Index Model::add_obstacle(const Surface& surface, Obstacle::Path path) {
  const Index first = add_object(surface, true);
  obstacles.push_back({first, static_cast<Index>(surface.points.size()), std::move(path)});
  return first;
}

Index Model::add_cloth(const Surface& surface, const Surface& sheet, const Fabric& fabric) {
  const Index first = add_object(surface, false);
  add_fabric(first, sheet, fabric);
  add_tethers(first, sheet);
  return first;
}

Index Model::add_solid(const Surface& surface, const Solid& solid, Index cells) {
  const Index first = add_object(surface, false);
  add_fabric(first, surface, solid.skin);
  const Lattice lattice = make_lattice(surface, cells);
  const Index node = add_particles(lattice.nodes);
  for (auto corners : lattice.tetrahedra) {
    for (Index& v : corners) v += node;
    tetrahedra.emplace_back(corners, particles.position, solid.elasticity);
    for (Index v : corners) add_mass(particles.inverse_mass[v], solid.density * tetrahedra.back().rest_volume() / 4);
  }
  for (Index v = 0; v < static_cast<Index>(surface.points.size()); ++v) {
    const auto carrier = static_cast<std::size_t>(lattice.tetrahedron_of_point[static_cast<std::size_t>(v)]);
    const auto& [a, b, c, d] = lattice.tetrahedra[carrier];
    attachments.push_back(make_attachment({first + v, node + a, node + b, node + c, node + d}, particles.position));
  }
  return first;
}

}  // namespace tamis::simulation
