// Long thin bodies: chains, ropes, hair, fibres.
#include "matrix/kinds/forms.hpp"
#include "matrix/kinds/kinds.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"

namespace tamis::matrix {

using namespace scenes;

Scene chain(Index triangles, std::uint64_t) {
  constexpr Index kLinks = 12;
  const Index around = side_for(triangles / (4 * kLinks)) - 1;
  Scene scene;
  for (Index link = 0; link < kLinks; ++link) {
    const auto at = [link](double gap, double swing) {
      return [=](double u) {
        const Point c = on_circle(u), middle{gap * link, swing * link, 0};
        return middle + (link % 2 == 0 ? c : Point{c[0], 0, c[1]});
      };
    };
    add_tube(scene, {4 * around, around, true, true}, 0.25, link, at(1.46, 0), at(1.47, 0.01));
  }
  return scene;
}

Scene rope_on_post(Index triangles, std::uint64_t) {
  constexpr Index kStrands = 3, kAround = 8;
  constexpr double kTurns = 2.5, kOffset = 0.058;
  const Index along = rows_for(triangles / 4, kAround);
  Scene scene;
  for (Index strand = 0; strand < kStrands; ++strand) {
    const auto at = [strand](double turn, double radius) {
      return [=](double u) {
        const Point laid = kOffset * on_circle(40 * u + double(strand) / kStrands);
        return (radius + laid[0]) * on_circle(kTurns * u + turn) + Point{0, 0, 0.6 * u + laid[1]};
      };
    };
    add_tube(scene, {along, kAround, false, true}, 0.049, strand, at(0, 1), at(0.001, 0.995));
  }
  const auto post = [](double u, double v) { return 0.88 * on_circle(v) + Point{0, 0, 2 * u - 0.7}; };
  add_surface(scene, {4, rows_for(triangles / 4, 3), false, true}, kStrands, post, post);
  return scene;
}

Scene hair(Index triangles, std::uint64_t seed) {
  constexpr Index kRows = 31, kTrianglesAStrip = 2 * (kRows - 1);
  const Index strips = std::max(Index{3}, triangles / kTrianglesAStrip);
  const SmoothNoise wind(seed);
  Random random(seed);
  Scene scene;
  for (Index strip = 0; strip < strips; ++strip) {
    const Point root = unit(random.point_between(-1, 1) + Point{0, 0, 0.6});
    const Point side = 0.01 * unit(cross(root, {0.3, 0.2, 1}));
    const auto at = [&](double u, double v, double sway) {
      const Point curl{wind(4 * root[0] + u, 4 * root[1], 1), wind(4 * root[1] + u, 4 * root[2], 5), 0};
      const Point own{wind(9 * root[0], 9 * root[1], 7), wind(9 * root[1], 9 * root[0], 8), 0};
      const Point hangs = (1 + 0.5 * u) * root + (v - 0.5) * side + (0.1 * u) * curl;
      return hangs + (sway * u) * own + Point{sway * u * u, 0, -0.9 * u * u};
    };
    add_surface(
        scene, {kRows, 2}, strip, [&](double u, double v) { return at(u, v, 0); },
        [&](double u, double v) { return at(u, v, 0.03); });
  }
  const auto head = [](const Point& p) { return 0.99 * p; };
  add_shape(scene, unit_sphere(sphere_cells(triangles / 10, 1, triangles)), strips, head, head);
  return scene;
}

Scene felt(Index triangles, std::uint64_t seed) {
  constexpr Index kEdges = 19;
  Random random(seed);
  Scene scene;
  for (Index fibre = 0; fibre <= triangles / kEdges; ++fibre) {
    Point p = random.point_between(-1, 1), direction = unit(random.point_between(-1, 1));
    direction[2] *= 0.3;
    p[2] *= 0.2;
    for (Index i = 0; i <= kEdges; ++i) {
      const Index v = scene.add_vertex(p, {p[0], p[1], 0.96 * p[2]}, fibre);
      if (i > 0) scene.loose_edges.push_back({v - 1, v});
      direction = unit(direction + 0.2 * random.point_between(-1, 1));
      direction[2] *= 0.7;
      p = p + 0.03 * direction;
    }
  }
  return scene;
}

}  // namespace tamis::matrix
