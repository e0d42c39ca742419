#include "bounds/shared_motion.hpp"

#include <algorithm>
#include <limits>

#include "tamis/components.hpp"

namespace tamis {
namespace {

/// Rests are floats: of more objects, farther apart, they would tell little.
constexpr Index kMostObjects = 8;
/// A gradient is worth the room it takes (NearQuestion) if it leaves half of the displacements: squares.
constexpr double kWorth = 4, kWorthOfObjects = 16;
constexpr double kLeastBeyond = 0x1p-4;
/// A rest then has components up to 2 + 3 * 2 sqrt(3) < 13 in the frame of the boxes, displacements differ by less than
/// 7, and rests that are kept so far apart by more.
constexpr double kSteepest = 3, kOffset = 64;

bool is_steep(const DisplacementGradient& gradient) {
  return !std::all_of(gradient.rows.begin(), gradient.rows.end(),
                      [](const Vec3<double>& row) { return dot(row, row) <= kSteepest * kSteepest; });
}

std::vector<std::vector<Index>> objects_of(const Mesh& mesh) {
  const Components components = components_of(mesh);
  if (components.count > kMostObjects) return {};
  std::vector<std::vector<Index>> objects(static_cast<std::size_t>(components.count));
  for (const Index v : mesh.points())
    objects[static_cast<std::size_t>(components.of_vertex[static_cast<std::size_t>(v)])].push_back(v);
  return objects;
}

}  // namespace

SharedMotion::SharedMotion(const Mesh& mesh) : mesh_(mesh), objects_(objects_of(mesh)) {}

void SharedMotion::fit(const Step& step, const BoxFrame& frame, double fraction) {
  const Part all{mesh_.points()};
  parts_ = {all};
  stretch_ = {};
  Fit scene = fit_parts(parts_, step, frame, fraction);
  double least = scene.displacement2;
  if (kWorth * scene.rest2 < least) {
    least = scene.rest2;
    take(std::move(scene));
  }
  if (objects_.size() < 2) return;
  std::vector<Part> parts;
  for (const auto& object : objects_) parts.push_back({object, {}, {}, kOffset * static_cast<double>(parts.size())});
  Fit each = fit_parts(std::move(parts), step, frame, fraction);
  if (kWorthOfObjects * each.rest2 < std::min(least, each.displacement2)) take(std::move(each));
}

SharedMotion::Fit SharedMotion::fit_parts(std::vector<Part> parts, const Step& step, const BoxFrame& frame,
                                          double fraction) {
  Fit result;
  bool is_any_steep = false;
  for (Part& part : parts) {
    const GradientFit fit = fit_gradient(step, frame, part.vertices);
    part.gradient = fit.gradient;
    part.middle = fit.middle;
    is_any_steep |= is_steep(fit.gradient);
    result.stretch = std::min(result.stretch, least_stretch(fit.gradient));
    const auto count = static_cast<double>(part.vertices.size());
    result.displacement2 += count * fit.displacement2;
    result.rest2 += count * fit.rest2;
  }
  const double left = result.stretch - fraction, weight = (1 - fraction) / left;
  result.rest2 *= weight * weight;
  if (is_any_steep || !(left > kLeastBeyond)) result.rest2 = std::numeric_limits<double>::infinity();
  result.parts = std::move(parts);
  return result;
}

std::uint64_t SharedMotion::memory_bytes() const {
  std::uint64_t bytes = 0;
  for (const auto& object : objects_) bytes += object.capacity() * sizeof(Index);
  return bytes;
}

void SharedMotion::take(Fit&& fit) {
  parts_ = std::move(fit.parts);
  stretch_ = {true, fit.stretch};
}

}  // namespace tamis
