// A sheet bent into a U moves in a subspace of nine smooth modes: each axis times three cosines over the sheet, among
// them those that close the arms.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "scenes/generators/generators.hpp"
#include "scenes/random.hpp"
#include "scenes/reduced_scene.hpp"
#include "scenes/shapes.hpp"

namespace tamis::scenes {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kArmRadius = kReducedArmGap / 2, kArm = 1.0, kWidth = 1.0;
constexpr double kLength = 2 * kArm + kPi * kArmRadius;
constexpr std::array<std::array<double, 2>, 3> kWaves{{{1, 0}, {2, 0}, {0, 1}}};
constexpr Index kModes = 3 * static_cast<Index>(kWaves.size());
constexpr double kUsualLength = 2.0;  ///< arms and sheet pass through each other for nearly every q

/// The point of the U at arc length s from the end of its lower arm, and at y across.
Point place(double s, double y) {
  if (s < kArm) return {s, y, -kArmRadius};
  const double angle = (s - kArm) / kArmRadius;
  if (angle < kPi) return {kArm + kArmRadius * std::sin(angle), y, -kArmRadius * std::cos(angle)};
  return {kLength - s, y, kArmRadius};
}

std::vector<double> random_direction(Random& random, double length) {
  std::vector<double> q;
  double squares = 0;
  for (Index k = 0; k < kModes; ++k) {
    q.push_back(random.between(-1, 1));
    squares += q.back() * q.back();
  }
  for (double& c : q) c *= length / std::sqrt(squares);
  return q;
}

Point moved(const ReducedScene& sheet, Index vertex, const std::vector<double>& q) {
  Point p = sheet.rest[static_cast<std::size_t>(vertex)];
  const double* u = sheet.basis.data() + std::ptrdiff_t{3} * vertex * kModes;
  for (double& x : p)
    for (const double amount : q) x += *u++ * amount;
  return p;
}

}  // namespace

ReducedScene reduced_sheet(Index triangles, std::uint64_t seed, double length) {
  const Index columns = std::max(Index{3}, static_cast<Index>(std::sqrt(triangles / (2 * kLength / kWidth))) + 1);
  const Index rows = std::max(Index{4}, triangles / (2 * (columns - 1)) + 1);
  Random random(seed);
  ReducedScene result;
  result.modes = kModes;
  for (Index i = 0; i < rows; ++i)
    for (Index j = 0; j < columns; ++j) {
      const double u = double(i) / (rows - 1), v = double(j) / (columns - 1);
      result.rest.push_back(place(kLength * u, kWidth * v));
      for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t k = 0; k < static_cast<std::size_t>(kModes); ++k) {
          const auto& wave = kWaves[k % kWaves.size()];
          const bool is_along = k / kWaves.size() == axis;
          result.basis.push_back(is_along ? 0.5 * std::cos(kPi * wave[0] * u) * std::cos(kPi * wave[1] * v) : 0.0);
        }
    }
  result.q_start = random_direction(random, length);
  result.q_end = random_direction(random, length);
  for (Index v = 0; v < rows * columns; ++v)
    result.scene.add_vertex(moved(result, v, result.q_start), moved(result, v, result.q_end), 0);
  add_grid_faces(result.scene, 0, rows, columns);
  result.scene.name = "reduced-sheet";
  return result;
}

Scene reduced_sheet_scene(Index triangles, std::uint64_t seed) {
  return reduced_sheet(triangles, seed, kUsualLength).scene;
}

}  // namespace tamis::scenes
