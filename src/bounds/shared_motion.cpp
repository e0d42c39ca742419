#include "bounds/shared_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tamis/components.hpp"

namespace tamis {
namespace {

/// Rests are floats: of more objects, farther apart, they would tell little.
constexpr Index kMostObjects = 8;
/// A gradient is worth the room it takes (NearQuestion) if it leaves half of the displacements: squares.
constexpr double kWorth = 4, kWorthOfObjects = 16;
constexpr double kLeastBeyond = 0x1p-4, kGreatest = 4;

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
  for (const auto& object : objects_) parts.push_back({object});
  Fit each = fit_parts(std::move(parts), step, frame, fraction);
  if (!(kWorthOfObjects * each.rest2 < std::min(least, each.displacement2))) return;
  take(std::move(each));
  keep_apart(step, frame);
}

SharedMotion::Fit SharedMotion::fit_parts(std::vector<Part> parts, const Step& step, const BoxFrame& frame,
                                          double fraction) {
  Fit result;
  for (Part& part : parts) {
    part.fit = fit_gradient(step, frame, part.vertices);
    const StretchBounds stretch = stretch_bounds(part.fit.gradient);
    result.stretch.least = std::min(result.stretch.least, stretch.least);
    result.stretch.greatest = std::max(result.stretch.greatest, stretch.greatest);
    const auto count = static_cast<double>(part.vertices.size());
    result.displacement2 += count * part.fit.displacement2;
    result.rest2 += count * part.fit.rest2;
  }
  const double left = result.stretch.least - fraction, weight = (1 - fraction) / left;
  result.rest2 *= weight * weight;
  if (!(left > kLeastBeyond && result.stretch.greatest <= kGreatest))
    result.rest2 = std::numeric_limits<double>::infinity();
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
  stretch_ = {fit.stretch, true};
}

/// Displacements differ by twice the longest at most.
void SharedMotion::keep_apart(const Step& step, const BoxFrame& frame) {
  double longest2 = 0, widest = 0;
  for (const Part& part : parts_)
    for (const Index v : part.vertices) {
      const Vec3<double> way = frame.displacement(step, v);
      longest2 = std::max(longest2, dot(way, way));
      widest = std::max(widest, std::fabs(part.rest(frame.place(step.start, v), way).x));
    }
  const double apart = 2 * (1 + 0x1p-20) * (widest + std::sqrt(longest2));
  for (std::size_t i = 0; i < parts_.size(); ++i) parts_[i].offset = apart * static_cast<double>(i);
}

}  // namespace tamis
