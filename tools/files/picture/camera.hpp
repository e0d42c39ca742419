// The camera of a picture, and its ray through each place of the picture.
#pragma once
#include <algorithm>
#include <cmath>
#include <span>

#include "files/picture/drawing.hpp"

namespace tamis::io {

/// y is up, unless one looks along it: then -z is.
class Camera {
 public:
  /// Looks from the direction `from`, and stands as near as all points stay within the picture. `aspect`: the picture's
  /// width over its height.
  Camera(const Vector& from, float aspect, std::span<const Vector> points)
      : back_(unit(from)),
        right_(unit(cross(std::abs(back_[1]) > kAlongUp ? Vector{0, 0, -1} : Vector{0, 1, 0}, back_))),
        up_(cross(back_, right_)),
        target_(middle(points, right_) * right_ + middle(points, up_) * up_),
        aspect_(aspect) {
    for (const Vector& point : points) {
      const Vector p = point - target_;
      const float sideways = std::max(std::abs(dot(p, right_)) / aspect_, std::abs(dot(p, up_)));
      distance_ = std::max(distance_, dot(p, back_) + kMargin * sideways / kSlope);
    }
  }

  /// The ray through (x, y) of the picture: (-1, -1) is the lower left corner, (1, 1) the upper right one.
  Ray sight(float x, float y) const {
    return {target_ + distance_ * back_, unit(kSlope * (aspect_ * x * right_ + y * up_) - back_), 0};
  }

  /// The size of a thing in the middle of the scene that takes up `part` of the picture's height.
  float size_of(float part) const { return 2 * distance_ * kSlope * part; }

  const Vector& back() const { return back_; }
  const Vector& right() const { return right_; }
  const Vector& up() const { return up_; }

 private:
  static constexpr float kSlope = 0.325F;   // of the upper border: an angle of 18 degrees
  static constexpr float kMargin = 1.06F;   // so that nothing touches the border
  static constexpr float kAlongUp = 0.99F;  // cosine of the angle to the axis

  /// The middle of the points' range along an axis.
  static float middle(std::span<const Vector> points, const Vector& axis) {
    const auto along = [&](const Vector& a, const Vector& b) { return dot(a, axis) < dot(b, axis); };
    const auto [lowest, highest] = std::minmax_element(points.begin(), points.end(), along);
    return points.empty() ? 0 : (dot(*lowest, axis) + dot(*highest, axis)) / 2;
  }

  Vector back_, right_, up_;
  Vector target_;
  float aspect_;
  float distance_ = 1e-3F;
};

}  // namespace tamis::io
