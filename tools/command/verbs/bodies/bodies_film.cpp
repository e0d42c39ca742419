#include "command/verbs/bodies/bodies_film.hpp"

#include <fmt/format.h>

#include "command/report.hpp"
#include "files/view/film.hpp"
#include "files/view/outputs.hpp"

namespace tamis::cli {
namespace {

std::vector<Index> first_vertices_of(const MovingBodies& bodies) {
  std::vector<Index> first;
  Index count = 0;
  for (std::size_t i = 0; i < bodies.count(); ++i) {
    first.push_back(count);
    count += static_cast<Index>(bodies.mesh_of(i).positions.size());
  }
  return first;
}

Mesh one_mesh(const MovingBodies& bodies, const std::vector<Index>& first_vertices) {
  io::MeshFile all;
  for (std::size_t i = 0; i < bodies.count(); ++i) {
    const io::MeshFile& mesh = bodies.mesh_of(i);
    const Index first = first_vertices[i];
    all.positions.insert(all.positions.end(), mesh.positions.begin(), mesh.positions.end());
    for (const Face& f : mesh.faces) all.faces.push_back({f[0] + first, f[1] + first, f[2] + first});
    for (const Edge& e : mesh.loose_edges) all.loose_edges.push_back({e[0] + first, e[1] + first});
    for (const Index v : mesh.loose_points) all.loose_points.push_back(v + first);
  }
  return io::mesh_of(std::move(all));
}

/// Each body is an object.
audit::Objects objects_of(const MovingBodies& bodies) {
  audit::Objects objects{{}, bodies.names()};
  for (std::size_t i = 0; i < bodies.count(); ++i)
    objects.of_vertex.insert(objects.of_vertex.end(), bodies.mesh_of(i).positions.size(), static_cast<Index>(i));
  return objects;
}

/// The motion of all bodies in the present step.
RigidPath path_of(const MovingBodies& bodies) {
  std::vector<Point> rest, rest_end;
  std::vector<Index> body_of_vertex;
  std::vector<RigidChain> chains;
  for (std::size_t i = 0; i < bodies.count(); ++i) {
    const std::vector<Point>*start = &bodies.mesh_of(i).positions, *end = start;
    if (const auto* stays = std::get_if<Static>(&bodies.motion_of(i))) {
      chains.push_back({{stays->pose, stays->pose}});
    } else if (const auto* rigid = std::get_if<Rigid>(&bodies.motion_of(i))) {
      chains.push_back(rigid->chain);
    } else {
      const auto& deforming = std::get<Deforming>(bodies.motion_of(i));
      chains.emplace_back();
      start = &deforming.start;
      end = &deforming.end;
    }
    rest.insert(rest.end(), start->begin(), start->end());
    rest_end.insert(rest_end.end(), end->begin(), end->end());
    body_of_vertex.insert(body_of_vertex.end(), start->size(), static_cast<Index>(i));
  }
  return {std::move(rest), std::move(body_of_vertex), std::move(chains), std::move(rest_end)};
}

/// How many of a contact's vertices are those of its first feature.
std::size_t vertices_of_first(PairKind kind) { return kind == PairKind::edge_edge ? 2 : 1; }

}  // namespace

BodiesFilm::BodiesFilm(const MovingBodies& bodies, const Options& options, AtStart at_start)
    : bodies_(bodies),
      first_vertices_(first_vertices_of(bodies)),
      options_(options),
      mesh_(one_mesh(bodies, first_vertices_)),
      recording_{mesh_, options_, 1, {}, {}, {}} {
  recording_.at_start = at_start;
  recording_.objects = objects_of(bodies);
}

void BodiesFilm::add(std::size_t step, const std::vector<BodyContact>& contacts, std::uint64_t ignored) {
  std::vector<Contact> all;
  for (const BodyContact& contact : contacts) all.push_back(in_one_mesh(contact));
  const std::string name = bodies_.step_count() == 1 ? "" : fmt::format("step {}, ", step);
  io::add_path(recording_, path_of(bodies_), {all, tally_of(all).toi_lower, ignored}, name);
}

Contact BodiesFilm::in_one_mesh(const BodyContact& contact) const {
  Contact all = contact;
  for (std::size_t k = 0; k < 4; ++k)
    if (all.vertices[k] >= 0)
      all.vertices[k] +=
          first_vertices_[static_cast<std::size_t>(contact.bodies[k < vertices_of_first(all.kind) ? 0 : 1])];
  return all;
}

void BodiesFilm::write(const std::filesystem::path& to) const {
  io::output_for(to, io::outputs()).write(to, recording_);
}

}  // namespace tamis::cli
