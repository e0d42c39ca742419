// A caller's path with a memory of positions at times that are asked for again: pairs cut at the same times then share
// the cost of these, such as that of the poses of turning bodies.
#pragma once
#include <vector>

#include "paths/frame.hpp"
#include "query/isolated.hpp"
#include "tamis/path.hpp"

namespace tamis {

/// For one thread, which takes no other part of the question while it waits in the caller's functions
/// (query/isolated.hpp). Positions are the path's own, bit for bit.
class RememberedPath final : public Path {
 public:
  /// Keeps references. `used`: ascending; others may be asked for, too.
  RememberedPath(const Path& path, const std::vector<Index>& used) : path_(path), used_(used) {}

  Index vertex_count() const override { return path_.vertex_count(); }
  void points_at(double time, std::span<const Index> vertices, std::span<Point> points,
                 std::span<double> errors) const override;
  void fine_points_at(double time, std::span<const Index> vertices, std::span<FinePoint> points) const override {
    isolated([&] { path_.fine_points_at(time, vertices, points); });
  }
  void deviations(double from, double to, std::span<const Index> vertices,
                  std::span<double> deviations) const override {
    isolated([&] { path_.deviations(from, to, vertices, deviations); });
  }
  void straight_directions(std::span<const Index> vertices, std::span<Point> directions) const override {
    isolated([&] { path_.straight_directions(vertices, directions); });
  }

 private:
  static constexpr std::size_t kMostTimesKept = 32, kMostTimesSeen = 32;

  /// Null where the time is asked for for the first time, or there is no more room.
  const Frame* kept_at(double time) const;
  /// Was it asked for before, among the last times? Remembers that it is now.
  bool was_seen(double time) const;
  /// False if a vertex is not a used one.
  bool copy(const Frame& from, std::span<const Index> vertices, std::span<Point> points,
            std::span<double> errors) const;

  const Path& path_;
  const std::vector<Index>& used_;
  mutable std::vector<Frame> kept_;   ///< of the used vertices, in their order
  mutable std::vector<double> seen_;  ///< asked for once, as most times are; the second time all vertices are kept
  mutable std::size_t oldest_ = 0;    ///< of those
};

}  // namespace tamis
