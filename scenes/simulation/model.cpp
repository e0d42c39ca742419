#include "scenes/simulation/model.hpp"

#include <Eigen/Geometry>

#include "scenes/simulation/lattice.hpp"

namespace tamis::simulation {
namespace {

Points as_points(const std::vector<Vec>& list) {
  Points points(3, static_cast<Eigen::Index>(list.size()));
  for (std::size_t i = 0; i < list.size(); ++i) points.col(static_cast<Eigen::Index>(i)) = list[i];
  return points;
}

Vec area_of(const Face& f, const Points& x) {
  return 0.5 * (x.col(f[1]) - x.col(f[0])).cross(x.col(f[2]) - x.col(f[0]));
}

Index corner_opposite(const Edge& edge, const Face& face) {
  for (Index v : face)
    if (v != edge[0] && v != edge[1]) return v;
  return edge[0];
}

/// Adds `mass` to what a particle weighs; a particle just made weighs nothing.
void add_mass(double& inverse_mass, double mass) {
  inverse_mass = inverse_mass > 0 ? 1 / (1 / inverse_mass + mass) : 1 / mass;
}

}  // namespace

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
  return first;
}

void Model::add_fabric(Index first, const Surface& sheet, const Fabric& fabric) {
  const Points rest = as_points(sheet.points);
  const Mesh mesh(static_cast<Index>(rest.cols()), sheet.faces);
  for (const Face& f : mesh.faces())
    for (Index v : f) add_mass(particles.inverse_mass[first + v], fabric.density * area_of(f, rest).norm() / 3);
  const auto edges = mesh.edges();
  for (Index e = 0; e < static_cast<Index>(edges.size()); ++e) {
    const auto [a, b] = edges[static_cast<std::size_t>(e)];
    distances.push_back({first + a, first + b, (rest.col(a) - rest.col(b)).norm(), 1 / fabric.stretch});
    const auto sides = mesh.faces_of_edge(e);
    if (fabric.bend == 0 || sides.size() != 2) continue;
    const Face left = mesh.faces()[static_cast<std::size_t>(sides[0])];
    const Face right = mesh.faces()[static_cast<std::size_t>(sides[1])];
    if (area_of(left, rest).dot(area_of(right, rest)) <= 0) continue;
    Bend bend = make_bend({a, b, corner_opposite({a, b}, left), corner_opposite({a, b}, right)}, rest, fabric.bend);
    for (Index& v : bend.vertices) v += first;
    bends.push_back(bend);
  }
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
