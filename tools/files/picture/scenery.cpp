#include "files/picture/scenery.hpp"

#include <algorithm>

#include "files/mesh/loose_features.hpp"
#include "files/output/contact_geometry.hpp"
#include "tamis/components.hpp"

namespace tamis::io {
namespace {

// Parts of the picture's height.
constexpr float kRodSize = 0.0035F;
constexpr float kPointSize = 0.005F;
constexpr float kContactSize = 0.004F;

Vector direction(const Point& p) {
  const double most = std::max({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
  return {static_cast<float>(p[0] / most), static_cast<float>(p[1] / most), static_cast<float>(p[2] / most)};
}

/// Night at the border, dusk in the middle, as in the viewer.
Light background(float x, float y) {
  const Rgb dark{0x0e, 0x13, 0x1b}, dusk{0x1b, 0x24, 0x32};
  return mix(light_of(dusk), light_of(dark), std::min(1.0F, (x * x + y * y) / 2));
}

}  // namespace

Scenery::Scenery(const Recording& recording, const PictureOptions& options)
    : step_(recording),
      time_(options.time),
      extent_(extent_of(recording.mesh, step_.start, step_.end)),
      vertices_(placed_vertices(recording.mesh)),
      camera_(direction(options.from), static_cast<float>(options.width) / static_cast<float>(options.height),
              vertices_) {
  draw_mesh(recording.mesh);
  draw_contacts(recording);
}

Vector Scenery::placed(const Point& point) const {
  Vector result{};
  // Divided before they are subtracted, lest the difference of two huge coordinates overflow.
  const double unit = extent_.half > 0 ? extent_.half : 1;
  for (std::size_t axis = 0; axis < 3; ++axis)
    result[axis] = static_cast<float>(point[axis] / unit - extent_.middle[axis] / unit);
  return result;
}

std::vector<Vector> Scenery::placed_vertices(const Mesh& mesh) const {
  std::vector<Vector> vertices(step_.start.size());
  for (const Index index : mesh.points()) {
    const auto v = static_cast<std::size_t>(index);
    vertices[v] = placed(point_at(step_.start[v], step_.end[v], time_));
  }
  return vertices;
}

void Scenery::draw_mesh(const Mesh& mesh) {
  const Components components = components_of(mesh);
  const auto add_colour = [&](Hit::Shape shape, Index vertex) {
    const Index object = components.of_vertex[static_cast<std::size_t>(vertex)];
    colours_[static_cast<std::size_t>(shape)].push_back(light_of(colour_of_object(static_cast<std::size_t>(object))));
  };
  surfaces_.add_triangles(vertices_, mesh.faces());
  for (const Face& face : mesh.faces()) add_colour(Hit::Shape::triangle, face[0]);
  const std::vector<Edge> rods = rods_of(mesh);
  surfaces_.add_rods(vertices_, rods, camera_.size_of(kRodSize));
  for (const Edge& rod : rods) add_colour(Hit::Shape::rod, rod[0]);
  std::vector<Vector> points;
  for (const Index v : loose_points_of(mesh)) {
    points.push_back(vertices_[static_cast<std::size_t>(v)]);
    add_colour(Hit::Shape::point, v);
  }
  surfaces_.add_points(points, camera_.size_of(kPointSize));
  surfaces_.finish();
}

void Scenery::draw_ball(const Point& point, double time) {
  contact_places_.push_back(placed(point));
  contact_colours_.push_back(light_of(colour_of_time(time)));
}

void Scenery::draw_contacts(const Recording& recording) {
  if (recording.pose)
    for (const Intersection& i : recording.pose->intersections) draw_ball(intersection_point(i, step_.start), 0);
  else
    for (const Contact& c : recording.steps.front().contacts)
      draw_ball(contact_point(c, step_.start, step_.end, time_), c.toi_lower);
  contacts_.add_points(contact_places_, camera_.size_of(kContactSize));
  contacts_.finish();
}

Light Scenery::seen_at(float x, float y, float turn, std::size_t part) const {
  const Ray sight = camera_.sight(x, y);
  Light light = background(x, y);
  const std::optional<Hit> surface = surfaces_.first_hit(sight), contact = contacts_.first_hit(sight);
  if (surface) {
    const Place place = place_of(sight, *surface);
    const Light& colour = colours_[static_cast<std::size_t>(surface->shape)][surface->element];
    light = shaded(colour, place, sky_at(surfaces_, place, turn, part), camera_);
  }
  if (!contact) return light;
  constexpr float kShinesThrough = 0.3F;
  const Light ball = (0.75F + 0.25F * dot(contact->normal, camera_.back())) * contact_colours_[contact->element];
  // The slack of a ball's size: half of a ball on a surface lies behind the surface, and the ball is still not hidden.
  const float slack = camera_.size_of(kContactSize);
  const bool is_hidden = surface && surface->distance + slack < contact->distance;
  return mix(light, ball, is_hidden ? kShinesThrough : 1);
}

}  // namespace tamis::io
