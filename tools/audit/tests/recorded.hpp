// Frames that are in memory already, for tests.
#pragma once
#include <functional>
#include <stdexcept>
#include <vector>

#include "audit/frame_source.hpp"

namespace tamis::test {

/// Gives frames one after the other, and throws at the end if it is told to.
class Recorded final : public audit::FrameSource {
 public:
  explicit Recorded(std::vector<audit::Frame> frames, bool throws_at_end = false)
      : frames_(std::move(frames)), throws_at_end_(throws_at_end) {}

  audit::FramePointer next() override {
    if (next_ < frames_.size()) return std::make_shared<const audit::Frame>(frames_[next_++]);
    if (throws_at_end_) throw std::runtime_error("the disk is gone");
    return nullptr;
  }

 private:
  std::vector<audit::Frame> frames_;
  std::size_t next_ = 0;
  bool throws_at_end_;
};

/// A sheet of n x n squares, whose side is 1, at the height that `height` gives of x and y.
inline std::vector<Point> sheet_points(int n, const std::function<double(double, double)>& height) {
  std::vector<Point> points;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      const double x = double(i) / n, y = double(j) / n;
      points.push_back({x, y, height(x, y)});
    }
  return points;
}

inline std::vector<Face> sheet_faces(int n, Index first = 0) {
  std::vector<Face> faces;
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i) {
      const Index at = first + j * (n + 1) + i;
      faces.push_back({at, at + 1, at + n + 2});
      faces.push_back({at, at + n + 2, at + n + 1});
    }
  return faces;
}

}  // namespace tamis::test
