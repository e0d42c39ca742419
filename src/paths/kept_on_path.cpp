#include "paths/kept_on_path.hpp"

#include <algorithm>

#include "paths/within_on_path.hpp"

namespace tamis {

KeptSeparation kept_separation(const Path& path, PairKind kind, const PairVertices& vertices,
                               const DistanceRule& rule) {
  PairReader reader(path, vertices);
  reader.set_unit_at(0);
  const auto moment = reader.at<double>(0);
  const PairPoints points = points_between(moment, moment);
  const DistanceBounds middles = start_distance_bounds(kind, points);
  const double slack = position_slack(moment.error), separation = rule.min_separation * reader.scale();
  const double low = (middles.low - slack) * (1 - 0x1p-50), high = (middles.high + slack) * (1 + 0x1p-50);
  const auto kept = [&](double distance) {
    return (separation + rule.fraction * std::max(distance - separation, 0.0)) / reader.scale();
  };
  return {kept(low) * (1 - 0x1p-50), kept(high) * (1 + 0x1p-50) + 0x1p-1000,
          start_distance(kind, points) / reader.scale(), !(low > separation)};
}

}  // namespace tamis
