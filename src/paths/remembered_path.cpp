#include "paths/remembered_path.hpp"

#include <algorithm>
#include <bit>

namespace tamis {
namespace {

/// The upper bits of a product depend on all bits of the time.
std::size_t hash_of(double time) {
  constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15;
  return static_cast<std::size_t>((std::bit_cast<std::uint64_t>(time) * kGolden) >> 32);
}

}  // namespace

void RememberedPath::points_at(double time, std::span<const Index> vertices, std::span<Point> points,
                               std::span<double> errors) const {
  Time& slot = times_[hash_of(time) % kTimes];
  if (slot.time != time) {
    slot.time = time;
    slot.points.clear();
  } else {
    if (slot.points.empty()) {
      slot.points.resize(used_.size());
      slot.errors.resize(used_.size());
      path_.points_at(time, used_, slot.points, slot.errors);
    }
    if (copy(slot, vertices, points, errors)) return;
  }
  path_.points_at(time, vertices, points, errors);
}

bool RememberedPath::copy(const Time& from, std::span<const Index> vertices, std::span<Point> points,
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
