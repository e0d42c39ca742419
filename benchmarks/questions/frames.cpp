#include "questions/frames.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "files/mesh/mesh_file.hpp"
#include "scenes/scene_list.hpp"

namespace tamis::bench {
namespace {

bool is_scene(const std::string& name) {
  const auto recipes = scenes::recipes();
  return std::any_of(recipes.begin(), recipes.end(), [&](const auto& recipe) { return recipe.name == name; });
}

/// Turns `p` by 60 degrees about an axis along z through `middle`; `side`, 1 or -1, is the sense of rotation.
Point turned(const Point& p, const Point& middle, int side) {
  const double c = 0.5, s = side * std::sqrt(0.75), x = p[0] - middle[0], y = p[1] - middle[1];
  return {middle[0] + (c * x - s * y), middle[1] + (s * x + c * y), p[2]};
}

struct Box {
  Point low, high;
};

Box box_of(const std::vector<Point>& points) {
  Box box{points.front(), points.front()};
  for (const Point& p : points)
    for (std::size_t k = 0; k < 3; ++k) {
      box.low[k] = std::min(box.low[k], p[k]);
      box.high[k] = std::max(box.high[k], p[k]);
    }
  return box;
}

}  // namespace

Frames read_frames(const std::string& first, const std::string& second) {
  if (is_scene(first)) {
    const scenes::Scene scene = scenes::scene_by_name(first, std::atoi(second.c_str()), 1);
    return {scene.mesh(), scene.start, scene.end};
  }
  io::MeshFile start = io::read_mesh(first);
  std::vector<Point> positions = start.positions;
  return {io::mesh_of(std::move(start)), std::move(positions), io::read_mesh(second).positions};
}

Frames turned_as_a_whole(const Frames& frames) {
  Frames result = frames;
  std::transform(result.start.begin(), result.start.end(), result.end.begin(), [](const Point& p) {
    return turned(p, {0, 0, 0}, 1);
  });
  return result;
}

Frames turned_against_each_other(const Frames& frames) {
  const Box box = box_of(frames.start);
  const double apart = 1.05 * (box.high[0] - box.low[0]);
  const Index count = frames.mesh.vertex_count();
  std::vector<Face> faces(frames.mesh.faces().begin(), frames.mesh.faces().end());
  for (const Face& f : frames.mesh.faces()) faces.push_back({f[0] + count, f[1] + count, f[2] + count});
  Frames result{Mesh(2 * count, std::move(faces)), {}, {}};
  for (const int side : {1, -1}) {
    const double shift = side > 0 ? 0 : apart;
    const Point middle{0.5 * (box.low[0] + box.high[0]) + shift, 0.5 * (box.low[1] + box.high[1]), 0};
    for (const Point& p : frames.start) {
      result.start.push_back({p[0] + shift, p[1], p[2]});
      result.end.push_back(turned(result.start.back(), middle, side));
    }
  }
  return result;
}

}  // namespace tamis::bench
