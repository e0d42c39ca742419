// The Stanford bunny, soft, between a floor and a plate that comes down.
#include <meshoptimizer.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "scenes/simulation/scenes.hpp"
#include "tamis/detector.hpp"
#include "tamis/error.hpp"

namespace tamis::simulation {
namespace {

constexpr const char* kBunnyFile = "/usr/share/glmark2/models/bunny.obj";
constexpr double kHeight = 0.2;        ///< of the bunny, metres
constexpr double kPlateSpeed = 0.094;  ///< metres per second, downwards
constexpr double kLeastRoom = 0.035;   ///< between floor and plate at the end, metres
constexpr Index kCells = 18;           ///< of the lattice, along the longest side
constexpr Index kSizesTried = 20;      ///< a hundredth apart

/// The vertices and triangles of the file, nothing else. Points that appear twice become one.
Surface read_bunny() {
  std::ifstream file(kBunnyFile);
  if (!file)
    throw Error(std::string(kBunnyFile) +
                " is missing: install the Debian package glmark2-data for the Stanford bunny");
  Surface bunny;
  std::map<std::array<double, 3>, Index> index_of;
  std::vector<Index> merged;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "v") {
      std::array<double, 3> p;
      words >> p[0] >> p[1] >> p[2];
      const auto [place, is_new] = index_of.try_emplace(p, static_cast<Index>(bunny.points.size()));
      if (is_new) bunny.points.emplace_back(p[0], -p[2], p[1]);
      merged.push_back(place->second);
    } else if (kind == "f") {
      Face face;
      for (Index& v : face) {
        std::string corner;
        words >> corner;
        v = merged.at(std::stoul(corner) - 1);
      }
      bunny.faces.push_back(face);
    }
  }
  return bunny;
}

/// Edge collapses by quadric error (meshoptimizer); keeps a subset of the points, and the topology.
Surface decimated(const Surface& fine, Index triangles) {
  std::vector<unsigned> indices;
  for (const Face& f : fine.faces)
    for (Index v : f) indices.push_back(static_cast<unsigned>(v));
  std::vector<float> coordinates;
  for (const Vec& p : fine.points)
    for (double c : p) coordinates.push_back(static_cast<float>(c));
  std::vector<unsigned> kept(indices.size());
  kept.resize(meshopt_simplify(kept.data(), indices.data(), indices.size(), coordinates.data(), fine.points.size(),
                               3 * sizeof(float), 3 * static_cast<std::size_t>(triangles), 1.0F));
  Surface coarse;
  std::map<unsigned, Index> index_of;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const auto [place, is_new] = index_of.try_emplace(kept[i], static_cast<Index>(coarse.points.size()));
    if (is_new) coarse.points.push_back(fine.points[kept[i]]);
    if (i % 3 == 0) coarse.faces.emplace_back();
    coarse.faces.back()[i % 3] = place->second;
  }
  return coarse;
}

bool is_free_of_intersections(const Surface& surface) {
  const auto count = static_cast<Index>(surface.points.size());
  return !Detector(Mesh(count, surface.faces)).has_intersection({surface.points.front().data(), count});
}

/// Edge collapses do not look for intersections: ears and chin may pass through each other. Tries sizes around
/// `triangles`, the nearest first, until the surface has no intersection.
Surface decimated_without_intersections(const Surface& fine, Index triangles) {
  for (Index k = 0; k <= kSizesTried; ++k) {
    const Index change = (k + 1) / 2 * std::max(2, triangles / 100);
    Surface coarse = decimated(fine, k % 2 == 0 ? triangles - change : triangles + change);
    if (is_free_of_intersections(coarse)) return coarse;
  }
  throw Error("the bunny passes through itself at every size near " + std::to_string(triangles) +
              " triangles: choose another number");
}

/// The bunny scaled to `height`, standing `clearance` above z = 0.
Surface placed(const Surface& bunny, double height, double clearance) {
  Eigen::AlignedBox3d bounds;
  for (const Vec& p : bunny.points) bounds.extend(p);
  const double scale = height / bounds.sizes().z();
  const Vec foot(bounds.center().x(), bounds.center().y(), bounds.min().z());
  return mapped(bunny, [&](const Vec& p) -> Vec { return scale * (p - foot) + Vec(0, 0, clearance); });
}

}  // namespace

Model bunny(Index triangles, std::uint64_t) {
  Model model;
  model.thickness = 0.001;
  const double clearance = 2 * model.thickness;
  const Surface surface =
      placed(decimated_without_intersections(read_bunny(), std::max(300, triangles - 400)), kHeight, clearance);
  model.add_obstacle(square(8, 0.6), at_rest);
  const double top = kHeight + 2 * clearance;
  model.add_obstacle(mapped(square(11, 0.4), [&](const Vec& p) -> Vec { return p + Vec(0, 0, top); }),
                     [top](double time) {
                       const double fall = std::min(kPlateSpeed * time, top - kLeastRoom);
                       return Eigen::Isometry3d(Eigen::Translation3d(0, 0, -fall));
                     });
  model.add_solid(surface, {1000, {2e4, 4e4}, {1, 500, 0}}, kCells);
  model.friction = 0.4;
  model.frame_time = 1.0 / 50;
  return model;
}

}  // namespace tamis::simulation
