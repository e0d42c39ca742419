// Makes shapes and worlds; adds, moves and changes bodies.
#include "c/world.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "c/mesh.hpp"
#include "c/motions.hpp"
#include "c/options.hpp"

namespace tamis::c {
namespace {

/// Refuses bodies that are named twice: the second time the body is gone.
void refuse_twice(std::span<const BodyId> bodies) {
  std::vector<BodyId> ordered(bodies.begin(), bodies.end());
  std::sort(ordered.begin(), ordered.end());
  const auto twice = std::adjacent_find(ordered.begin(), ordered.end());
  if (twice != ordered.end())
    throw InvalidOptions("body " + std::to_string(*twice) + " is named twice: give each once");
}

/// Runs `work(world)`. A body that does not exist is refused before anything changes.
template <class Work>
void change(World& world, std::span<const BodyId> bodies, const Work& work) {
  for (const BodyId body : bodies) static_cast<void>(world.motion(body));
  work(world);
}

}  // namespace
}  // namespace tamis::c

using namespace tamis::c;

tamis_status tamis_shape_create(const tamis_mesh* mesh, const double* points, const tamis_shape_options* options,
                                tamis_shape** shape) {
  return make_handle(shape, [&](tamis_shape& handle) {
    const auto& of = made<tamis::InvalidMesh>(mesh, "mesh");
    const tamis::Isa isa = isa_of(read_options(options).isa);
    handle.object.emplace(of, point_rows(points, static_cast<std::size_t>(of.vertex_count()), "points"), isa);
  });
}

void tamis_shape_free(tamis_shape* shape) { delete shape; }

const char* tamis_shape_message(const tamis_shape* shape) { return message_of(shape); }

tamis_status tamis_world_create(const tamis_world_options* options, tamis_world** world) {
  return make_handle(world, [&](tamis_world& handle) { handle.object.emplace(options_of(read_options(options))); });
}

void tamis_world_free(tamis_world* world) { delete world; }

const char* tamis_world_message(const tamis_world* world) { return message_of(world); }

tamis_status tamis_world_add(tamis_world* world, const tamis_shape* shape, const tamis_motions* motions,
                             int32_t* bodies) {
  return with(world, [&](tamis_world& handle) {
    const tamis_motions given = read_sized(motions, "motions");
    check_count(given.count, "count");
    if (given.count > 0) required(bodies, "bodies");
    std::ranges::copy(handle.object->add_many(made<tamis::InvalidMesh>(shape, "shape"), motions_of(given)), bodies);
  });
}

tamis_status tamis_world_move(tamis_world* world, const int32_t* bodies, const tamis_motions* motions) {
  return with(world, [&](tamis_world& handle) {
    const tamis_motions given = read_sized(motions, "motions");
    handle.object->move_many(bodies_of(bodies, given.count, "count"), motions_of(given));
  });
}

tamis_status tamis_world_points_at(tamis_world* world, int32_t body, double time, int32_t vertex_count, double* points,
                                   double* error) {
  return with(world, [&](tamis_world& handle) {
    const tamis::BodyPoints found = handle.object->points_at(body, time);
    if (vertex_count < 0 || static_cast<std::size_t>(vertex_count) != found.points.size())
      throw InvalidArgument("vertex_count is " + std::to_string(vertex_count) + ", and body " + std::to_string(body) +
                            " has " + std::to_string(found.points.size()) +
                            " vertices: give as many, and room for them");
    if (vertex_count > 0) copy_points(found.points, &required(points, "points"));
    if (error) *error = found.error;
  });
}

tamis_status tamis_world_remove(tamis_world* world, const int32_t* bodies, size_t count) {
  return with(world, [&](tamis_world& handle) {
    const auto named = bodies_of(bodies, count, "count");
    refuse_twice(named);
    change(*handle.object, named, [&](tamis::World& w) {
      for (const tamis::BodyId body : named) w.remove(body);
    });
  });
}

tamis_status tamis_world_set_enabled(tamis_world* world, const int32_t* bodies, size_t count, int is_enabled) {
  return with(world, [&](tamis_world& handle) {
    const auto named = bodies_of(bodies, count, "count");
    change(*handle.object, named, [&](tamis::World& w) {
      for (const tamis::BodyId body : named) w.set_enabled(body, is_enabled != 0);
    });
  });
}

tamis_status tamis_world_set_radius(tamis_world* world, const int32_t* bodies, size_t count, double radius) {
  return with(world, [&](tamis_world& handle) {
    const auto named = bodies_of(bodies, count, "count");
    change(*handle.object, named, [&](tamis::World& w) {
      for (const tamis::BodyId body : named) w.set_radius(body, radius);
    });
  });
}

tamis_status tamis_world_set_may_touch(tamis_world* world, const int32_t* bodies, size_t count, int may_touch) {
  return with(world, [&](tamis_world& handle) {
    check_count(count, "count");
    const auto named = bodies_of(bodies, 2 * count, "count");
    const auto* first = reinterpret_cast<const std::array<tamis::BodyId, 2>*>(named.data());
    handle.object->set_may_touch({first, count}, may_touch != 0);
  });
}
