// A caller's path with a cache of positions. Pairs that are cut at the same times share the cost of these positions.
// The poses of turning bodies are an example.
#pragma once
#include <vector>

#include "curves/paths/mesh_moment.hpp"
#include "numbers/parallel.hpp"
#include "tamis/path.hpp"

namespace tamis {

/// For one thread. While this thread waits in the caller's functions, it takes no other part of the question
/// (numbers/parallel.hpp). Positions are the path's own, bit for bit.
class CachedPath final : public Path {
 public:
  /// Keeps references. `used`: the vertices to cache, ascending; others may be requested, too.
  CachedPath(const Path& path, const std::vector<Index>& used) : path_(path), used_(used) {}

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
  std::optional<CarriedPath> carried(std::span<const Index> vertices) const override {
    std::optional<CarriedPath> found;
    isolated([&] { found = path_.carried(vertices); });
    return found;
  }

 private:
  static constexpr std::size_t kMostTimesCached = 32, kMostTimesSeen = 32;

  /// The used vertices at a time, cached when the time is requested for the second time. Null the first time, or if the
  /// cache is full.
  const MeshMoment* cached_at(double time) const;
  /// True if the time is among the last kMostTimesSeen requested. If not, stores it.
  bool was_seen(double time) const;
  /// Copies positions from the cache. Returns false if a vertex is not among the used ones.
  bool copy(const MeshMoment& from, std::span<const Index> vertices, std::span<Point> points,
            std::span<double> errors) const;

  const Path& path_;
  const std::vector<Index>& used_;
  mutable std::vector<MeshMoment> cached_;  ///< each of the used vertices, in their order
  mutable std::vector<double> seen_;        ///< the last times requested; most are requested only once
  mutable std::size_t oldest_ = 0;          ///< place in seen_ of the oldest time, modulo kMostTimesSeen
};

}  // namespace tamis
