// A pair of a path in the frame that carries it (Path::carried), or in the world if the path knows none. A pair that
// does not move in its frame is decided once, for all times.
#pragma once
#include "curves/paths/decide_path.hpp"

namespace tamis {

class CarriedPair {
 public:
  /// Keeps a reference to the path.
  CarriedPair(const Path& path, PairKind kind, const PairVertices& vertices)
      : path_(&path), vertices_(vertices), carried_(path.carried(std::span(vertices).first(vertex_count(kind)))) {
    if (!carried_) return;
    path_ = carried_->path.get();
    for (std::size_t i = 0; i < vertex_count(kind); ++i) vertices_[i] = static_cast<Index>(i);
  }
  CarriedPair(const CarriedPair&) = delete;

  const Path& path() const { return *path_; }
  const PairVertices& vertices() const { return vertices_; }
  bool is_still() const { return carried_ && carried_->is_still; }
  Point to_world(double time, const Point& direction) const {
    return carried_ ? carried_->to_world(time, direction) : direction;
  }
  /// The result of a question about path() and vertices(), in the world.
  PairResult in_world(PairResult result) const {
    if (result.touches) result.normal = to_world(result.toi_lower, result.normal);
    return result;
  }

 private:
  const Path* path_;
  PairVertices vertices_;
  const std::optional<CarriedPath> carried_;
};

}  // namespace tamis
