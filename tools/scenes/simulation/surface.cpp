#include "scenes/simulation/surface.hpp"

#include <Eigen/Geometry>
#include <numbers>

#include "scenes/shapes.hpp"

namespace tamis::simulation {
namespace {

/// Point j of the 6 k points of ring k; the centre is ring 0.
Index in_ring(Index k, Index j) { return k == 0 ? 0 : 1 + 3 * k * (k - 1) + j % (6 * k); }

/// Sixth `sector` of the band between rings k-1 and k: k triangles that point inwards, k-1 that point outwards.
void add_band_faces(std::vector<Face>& faces, Index k, Index sector) {
  const Index outer = sector * k, inner = sector * (k - 1);
  for (Index i = 0; i < k; ++i) {
    faces.push_back({in_ring(k, outer + i), in_ring(k, outer + i + 1), in_ring(k - 1, inner + i)});
    if (i + 1 < k)
      faces.push_back({in_ring(k - 1, inner + i), in_ring(k, outer + i + 1), in_ring(k - 1, inner + i + 1)});
  }
}

}  // namespace

Surface square(Index cells, double side) {
  Surface result;
  const auto at = [cells](Index i, Index j) { return i * (cells + 1) + j; };
  for (Index i = 0; i <= cells; ++i)
    for (Index j = 0; j <= cells; ++j)
      result.points.emplace_back(side * (static_cast<double>(i) / cells - 0.5),
                                 side * (static_cast<double>(j) / cells - 0.5), 0);
  for (Index i = 0; i < cells; ++i) {
    for (Index j = 0; j < cells; ++j) {
      const Index a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      if ((i + j) % 2 == 0)
        result.faces.insert(result.faces.end(), {{a, b, c}, {a, c, d}});
      else
        result.faces.insert(result.faces.end(), {{a, b, d}, {b, c, d}});
    }
  }
  return result;
}

Surface disc(Index rings, double radius) {
  Surface result{{Vec::Zero()}, {}};
  for (Index k = 1; k <= rings; ++k) {
    for (Index j = 0; j < 6 * k; ++j) {
      const double angle = kPi / 3 * j / k, r = radius * k / rings;
      result.points.emplace_back(r * std::cos(angle), r * std::sin(angle), 0);
    }
    for (Index sector = 0; sector < 6; ++sector) add_band_faces(result.faces, k, sector);
  }
  return result;
}

Surface pillow(Index rings, double radius, double gap) {
  Surface result = disc(rings, radius);
  const Index rim = in_ring(rings, 0), upper = static_cast<Index>(result.points.size());
  for (Index v = 0; v < rim; ++v) {
    Vec& p = result.points[static_cast<std::size_t>(v)];
    p.z() = gap / 2;
    const Vec below(p.x(), p.y(), -gap / 2);
    result.points.push_back(below);
  }
  const auto below = [&](Index v) { return v < rim ? upper + v : v; };
  const std::vector<Face> top = result.faces;
  for (const Face& f : top) result.faces.push_back({below(f[0]), below(f[2]), below(f[1])});
  return result;
}

Surface ball(Index cells, double radius) {
  const scenes::Shape unit = scenes::unit_sphere(cells);
  Surface result{{}, unit.faces};
  for (const Point& p : unit.points) result.points.push_back(radius * Vec(p.data()));
  return result;
}

Surface revolved(const std::vector<Vec>& profile, Index segments, bool closed) {
  Surface result;
  const auto rows = static_cast<Index>(profile.size());
  for (const Vec& p : profile)
    for (Index j = 0; j < segments; ++j)
      result.points.push_back(Eigen::AngleAxisd(2 * kPi * j / segments, Vec::UnitZ()) * p);
  const auto at = [&](Index i, Index j) { return (i % rows) * segments + j % segments; };
  for (Index i = 0; i < (closed ? rows : rows - 1); ++i) {
    for (Index j = 0; j < segments; ++j) {
      result.faces.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1)});
      result.faces.push_back({at(i, j), at(i + 1, j + 1), at(i + 1, j)});
    }
  }
  return result;
}

Surface box(const Vec& size) {
  Surface result;
  for (int corner = 0; corner < 8; ++corner)
    result.points.push_back(
        size.cwiseProduct(Vec((corner & 1) - 0.5, ((corner >> 1) & 1) - 0.5, ((corner >> 2) & 1) - 0.5)));
  result.faces = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                  {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return result;
}

Surface joined(const std::vector<Surface>& surfaces) {
  Surface result;
  for (const Surface& s : surfaces) {
    const auto first = static_cast<Index>(result.points.size());
    result.points.insert(result.points.end(), s.points.begin(), s.points.end());
    for (const Face& f : s.faces) result.faces.push_back({first + f[0], first + f[1], first + f[2]});
  }
  return result;
}

}  // namespace tamis::simulation
