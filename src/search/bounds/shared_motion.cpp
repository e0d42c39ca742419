#include "search/bounds/shared_motion.hpp"

#include <cmath>

#include "numbers/error_bounds.hpp"

namespace tamis {
namespace {

/// About how many are sampled.
constexpr std::size_t kSampledVertices = 4096, kSampledEdges = 1024;
/// The clearance that a gradient costs, relative to the length of edges. It is the clearance of boxes eight edges wide,
/// a guess at the boxes of near pairs. No answer depends on it.
constexpr double kEdgeAdvanceClearance = 8 * error_bounds::kBoxAdvanceClearance;
/// By how much the least stretch must exceed the fraction, and how large the greatest may be. Otherwise the clearance
/// costs more than the gradient gains.
constexpr double kLeastBeyond = 0x1p-4, kGreatestStretch = 4;

Vec3<double> rounded_difference(const double* to, const double* from, double scale) {
  return {scale * (to[0] - from[0]), scale * (to[1] - from[1]), scale * (to[2] - from[2])};
}

/// The root mean square of residual differences along edges, over that of the edges' lengths, without outliers. Not
/// finite where differences are not; then there is no gradient.
double growth_beside(const DisplacementGradient& gradient, const Mesh& mesh, const PackedMotion& motion) {
  double residual2 = 0, length2 = 0;
  const auto edges = mesh.edges();
  for (std::size_t e = 0; e < edges.size(); e += edges.size() / kSampledEdges + 1) {
    if (motion.is_outlier(edges[e][0]) || motion.is_outlier(edges[e][1])) continue;
    const PackedVertex& a = motion.vertices[static_cast<std::size_t>(edges[e][0])];
    const PackedVertex& b = motion.vertices[static_cast<std::size_t>(edges[e][1])];
    const Vec3<double> length = rounded_difference(b.start(), a.start(), motion.frame.scale);
    const Vec3<double> residual =
        rounded_difference(b.end(), a.end(), motion.frame.scale) - length - gradient.at(length);
    residual2 += dot(residual, residual);
    length2 += dot(length, length);
  }
  return length2 > 0 ? std::sqrt(residual2 / length2) : 0;
}

}  // namespace

SharedMotion fit_shared_motion(const Mesh& mesh, const PackedMotion& motion, double fraction) {
  const double most = growth_beside({}, mesh, motion) / (1 - fraction);
  if (!(kEdgeAdvanceClearance / (1 - fraction) < most)) return {};  // no gradient can gain enough
  const auto points = mesh.points();
  const GradientFit fit = fit_gradient(motion, points, points.size() / kSampledVertices + 1);
  const StretchBounds stretch = stretch_bounds(fit.gradient);
  const double left = stretch.least - fraction;
  if (!(left > kLeastBeyond && stretch.greatest <= kGreatestStretch)) return {};
  if (!((growth_beside(fit.gradient, mesh, motion) + kEdgeAdvanceClearance) / left < most)) return {};
  return {true, fit, stretch};
}

}  // namespace tamis
