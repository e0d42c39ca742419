#include "search/coherence/predicted_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "numbers/assert.hpp"
#include "numbers/in_parts.hpp"
#include "search/topology/at.hpp"

namespace tamis {

void PredictedStep::make(const Step& step, std::span<const Index> vertices, double steps) {
  TAMIS_ASSERT(step.start.count() == step.end.count() && steps > 0);
  vertices_ = vertices;
  to_.resize(vertices.size());
  from_.resize(vertices.size());  // last, as it tells is_made()
  in_parts(vertices.size(), kVerticesPerPart, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        from_[i][axis] = step.start[vertices[i]][axis];
        to_[i][axis] = from_[i][axis] + steps * (step.end[vertices[i]][axis] - from_[i][axis]);
      }
  });
}

PredictedStep::Ends PredictedStep::ends(Index count) const {
  Ends ends{std::vector<Point>(at(count)), std::vector<Point>(at(count))};
  for (std::size_t i = 0; i < from_.size(); ++i) {
    ends.start[at(vertices_[i])] = from_[i];
    ends.end[at(vertices_[i])] = to_[i];
  }
  return ends;
}

std::optional<PredictedStep::Fit> PredictedStep::fit(const Step& step, double most) const {
  if (!is_made()) return {};
  TAMIS_ASSERT(vertices_.back() < step.start.count());
  const double start = nearest_time(step.start);
  const auto at_start = deviation(step.start, start, most);
  if (!at_start) return {};
  const double end = nearest_time(step.end);
  const auto at_end = start <= end ? deviation(step.end, end, most) : std::nullopt;
  if (!at_end) return {};
  return Fit{start, end, std::max(*at_start, *at_end)};
}

/// The time of the predicted step nearest to these positions, by least squares over a sample of the vertices.
double PredictedStep::nearest_time(const Positions& positions) const {
  double along = 0, all = 0;
  for (std::size_t i = 0; i < vertices_.size(); i += 1 + vertices_.size() / kSampleVertices) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double length = to_[i][axis] - from_[i][axis];
      along += length * (positions[vertices_[i]][axis] - from_[i][axis]);
      all += length * length;
    }
  }
  return all > 0 ? std::clamp(along / all, 0.0, 1.0) : 0;
}

/// The largest deviation, by sums over the axes, which bound distances; nothing beyond `most`. 2^-49: rounding
/// (docs/numerics/steps.md, "Pairs listed ahead").
std::optional<double> PredictedStep::deviation(const Positions& positions, double t, double most) const {
  constexpr double kTooFar = std::numeric_limits<double>::infinity();
  const auto largest_of_part = [&](std::size_t begin, std::size_t end) {
    double largest = 0;
    for (std::size_t i = begin; i < end; ++i) {
      double off = 0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double a = from_[i][axis], b = to_[i][axis], x = positions[vertices_[i]][axis];
        off += std::fabs(x - (a + t * (b - a))) + 0x1p-49 * (std::fabs(a) + std::fabs(b) + std::fabs(x));
      }
      if (!(off <= most)) return kTooFar;
      largest = std::max(largest, off);
    }
    return largest;
  };
  const auto larger = [](double a, double b) { return std::max(a, b); };
  const double largest = joined_parts(from_.size(), kVerticesPerPart, 0.0, larger, largest_of_part);
  return largest < kTooFar ? std::optional(largest) : std::nullopt;
}

}  // namespace tamis
