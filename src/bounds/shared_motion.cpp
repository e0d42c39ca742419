#include "bounds/shared_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tamis/components.hpp"

namespace tamis {
namespace {

/// More objects are one. Of all together about so many vertices are looked at.
constexpr Index kMostObjects = 256;
constexpr std::size_t kSampledVertices = 4096;
/// Nothing cancels between objects that move differently: little is won by more motions, or where more of the pairs of
/// two lie within half of the longest displacement beside a translation.
constexpr std::size_t kMostMotions = 8;
constexpr double kMostPairsNearShare = 0.5;
/// A gradient is worth the room it takes (StepLengthQuery) if it leaves half of the displacements: squares.
constexpr double kLeastGain = 4, kLeastGainOfMotions = 16;
/// So much is left beyond the fraction, and distances grow by so much at most: else the room takes more than is won.
constexpr double kLeastBeyond = 0x1p-4, kGreatestStretch = 4;

std::vector<std::vector<Index>> objects_of(const Mesh& mesh) {
  const Components components = components_of(mesh);
  const bool is_one = components.count > kMostObjects;
  std::vector<std::vector<Index>> objects(static_cast<std::size_t>(is_one ? 1 : components.count));
  for (const Index v : mesh.points())
    objects[is_one ? 0 : static_cast<std::size_t>(components.of_vertex[static_cast<std::size_t>(v)])].push_back(v);
  std::erase_if(objects, [](const auto& object) { return object.empty(); });
  std::stable_sort(objects.begin(), objects.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
  return objects;
}

struct Extent {
  Vec3<double> low{1e300, 1e300, 1e300}, high = -low;

  void include(const Vec3<double>& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  bool is_within(double reach, const Vec3<double>& p) const {
    const Vec3<double> below = low - p, above = p - high;
    return std::max({below.x, below.y, below.z, above.x, above.y, above.z}) <= reach;
  }
};

}  // namespace

SharedMotion::SharedMotion(const Mesh& mesh) : objects_(objects_of(mesh)), vertex_count_(mesh.points().size()) {}

void SharedMotion::fit(const Step& step, const BoxFrame& frame, double fraction) {
  parts_.clear();
  stretch_ = {};
  std::vector<DisplacementMoments> moments;
  Motion scene;
  double turned2 = 0;  // squares of displacements beside a translation of each object
  for (const auto& object : objects_) {
    parts_.push_back({object});
    moments.push_back(moments_of(step, frame, object, stride()));
    scene.objects.push_back(scene.objects.size());
    scene.moments += moments.back();
    turned2 += moments.back().displacement2();
  }
  const double displacement2 = scene.moments.displacement2();
  const Fit one = fit_to({&scene, 1}, fraction, displacement2 / kLeastGain);
  const bool is_worth = kLeastGain * one.residual2 < displacement2;
  if (is_worth) take({&scene, 1}, one);
  const double most_residual2 = std::min(is_worth ? one.residual2 : displacement2, turned2) / kLeastGainOfMotions;
  const std::vector<Motion> motions = motions_of_objects(moments, 0.5 * most_residual2);
  if (motions.size() < 2) return;
  const Fit each = fit_to(motions, fraction, most_residual2);
  if (!(each.residual2 < most_residual2)) return;
  if (!lie_apart(motions, each, step, frame)) return;
  take(motions, each);
  keep_apart(motions, step, frame);
}

/// Each object joins the motion that explains it best, if then no more is left of the object than its share of
/// `most_residual2`; else it begins one.
std::vector<SharedMotion::Motion> SharedMotion::motions_of_objects(std::span<const DisplacementMoments> objects,
                                                                   double most_residual2) const {
  std::vector<Motion> motions;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    double least = most_residual2 * objects[i].count() / static_cast<double>(vertex_count_);
    Motion* best = nullptr;
    for (Motion& motion : motions) {
      DisplacementMoments both = motion.moments;
      both += objects[i];
      const double more = both.fit().residual2 - motion.moments.fit().residual2;
      if (!(more <= least)) continue;
      least = more;
      best = &motion;
    }
    if (!best) {
      if (motions.size() == kMostMotions) return {};
      best = &motions.emplace_back();
    }
    best->objects.push_back(i);
    best->moments += objects[i];
  }
  return motions;
}

SharedMotion::Fit SharedMotion::fit_to(std::span<const Motion> motions, double fraction, double most_residual2) {
  Fit result;
  for (const Motion& motion : motions) {
    result.fits.push_back(motion.moments.fit());
    result.residual2 += result.fits.back().residual2;
  }
  if (!(result.residual2 < most_residual2)) return result;  // what the stretch takes makes it no less
  for (const GradientFit& fit : result.fits) {
    const StretchBounds stretch = stretch_bounds(fit.gradient);
    result.stretch.least = std::min(result.stretch.least, stretch.least);
    result.stretch.greatest = std::max(result.stretch.greatest, stretch.greatest);
  }
  const double left = result.stretch.least - fraction, weight = (1 - fraction) / left;
  result.residual2 *= weight * weight;
  if (!(left > kLeastBeyond && result.stretch.greatest <= kGreatestStretch))
    result.residual2 = std::numeric_limits<double>::infinity();
  return result;
}

std::uint64_t SharedMotion::memory_bytes() const {
  std::uint64_t bytes = 0;
  for (const auto& object : objects_) bytes += object.capacity() * sizeof(Index);
  return bytes;
}

void SharedMotion::take(std::span<const Motion> motions, const Fit& fit) {
  for (std::size_t m = 0; m < motions.size(); ++m)
    for (const std::size_t i : motions[m].objects) parts_[i].fit = fit.fits[m];
  stretch_ = {fit.stretch, true};
}

std::size_t SharedMotion::stride() const { return vertex_count_ / kSampledVertices + 1; }

bool SharedMotion::lie_apart(std::span<const Motion> motions, const Fit& fit, const Step& step,
                             const BoxFrame& frame) const {
  const auto for_each_vertex = [&](const Motion& motion, const auto& f) {
    for (const std::size_t i : motion.objects)
      for (std::size_t k = 0; k < objects_[i].size(); k += stride())
        f(objects_[i][k], frame.place(step.start, objects_[i][k]));
  };
  std::vector<Extent> extents(motions.size());
  double longest2 = 0;
  for (std::size_t m = 0; m < motions.size(); ++m)
    for_each_vertex(motions[m], [&](Index v, const Vec3<double>& place) {
      extents[m].include(place);
      const Vec3<double> way = frame.displacement(step, v) - fit.fits[m].way;
      longest2 = std::max(longest2, dot(way, way));
    });
  const double reach = 0.5 * std::sqrt(longest2);
  const auto share_within = [&](const Extent& extent, const Motion& motion) {
    double within = 0, all = 0;
    for_each_vertex(motion, [&](Index, const Vec3<double>& place) {
      within += extent.is_within(reach, place);
      ++all;
    });
    return within / all;
  };
  for (std::size_t a = 0; a < motions.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      if (share_within(extents[a], motions[b]) * share_within(extents[b], motions[a]) > kMostPairsNearShare)
        return false;
  return true;
}

/// Displacements differ by twice the longest at most.
void SharedMotion::keep_apart(std::span<const Motion> motions, const Step& step, const BoxFrame& frame) {
  double longest2 = 0, widest = 0;
  for (const Part& part : parts_)
    for (const Index v : part.vertices) {
      const Vec3<double> way = frame.displacement(step, v);
      longest2 = std::max(longest2, dot(way, way));
      widest = std::max(widest, std::fabs(part.residual(frame.place(step.start, v), way).x));
    }
  const double apart = 2 * (1 + 0x1p-20) * (widest + std::sqrt(longest2));
  for (std::size_t m = 0; m < motions.size(); ++m)
    for (const std::size_t i : motions[m].objects) parts_[i].offset = apart * static_cast<double>(m);
}

}  // namespace tamis
