#include "curves/paths/cached_path.hpp"

#include <algorithm>

namespace tamis {

void CachedPath::points_at(double time, std::span<const Index> vertices, std::span<Point> points,
                           std::span<double> errors) const {
  const MeshMoment* cached = cached_at(time);
  if (!cached || !copy(*cached, vertices, points, errors))
    isolated([&] { path_.points_at(time, vertices, points, errors); });
}

const MeshMoment* CachedPath::cached_at(double time) const {
  const auto found = std::find_if(cached_.begin(), cached_.end(), [&](const MeshMoment& t) { return t.time == time; });
  if (found != cached_.end()) return &*found;
  if (!was_seen(time) || cached_.size() >= kMostTimesCached) return nullptr;
  MeshMoment& now =
      cached_.emplace_back(MeshMoment{time, std::vector<Point>(used_.size()), std::vector<double>(used_.size())});
  isolated([&] { path_.points_at(time, used_, now.points, now.errors); });
  return &now;
}

bool CachedPath::was_seen(double time) const {
  if (std::find(seen_.begin(), seen_.end(), time) != seen_.end()) return true;
  if (seen_.size() < kMostTimesSeen)
    seen_.push_back(time);
  else
    seen_[oldest_++ % kMostTimesSeen] = time;
  return false;
}

bool CachedPath::copy(const MeshMoment& from, std::span<const Index> vertices, std::span<Point> points,
                      std::span<double> errors) const {
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const auto found = std::lower_bound(used_.begin(), used_.end(), vertices[i]);
    if (found == used_.end() || *found != vertices[i]) return false;
    const auto place = static_cast<std::size_t>(found - used_.begin());
    points[i] = from.points[place];
    errors[i] = from.errors[place];
  }
  return true;
}

}  // namespace tamis
