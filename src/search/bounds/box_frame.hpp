// The common frame of boxes in floats. Holds its origin and scale, and how much rounding in it may hide.
#pragma once
#include <array>

#include "numbers/vec.hpp"

namespace tamis {

class SceneVertices;
struct PackedVertex;

/// box coordinate = (coordinate - origin) * scale: within [-1,1] for every vertex of the step but outliers. Scale is a
/// power of two, and the origin follows the scene. So the unit of length changes no decision. Where the scene moves far
/// as a whole, the frame moves with it, straight from `origin` to `origin_at_end`: motions stay linear, and relative
/// motions stay the same.
struct BoxFrame {
  std::array<double, 3> origin, origin_at_end;
  double scale;
  double widening;  ///< the scene's width at t=1 over that at t=0; NaN if it is a point at both
  /// True if the frame holds only the finest part of the scene. Vertices that are far away lie outside, as outliers.
  /// Rounding hides more of an outlier the larger its coordinates are. That is added to its radius (kOutlierMargin).
  bool has_outliers;
  /// Added on each side of a box. Rounding to float is off by 2^-25, the subtraction by 2^-53, the box's own
  /// subtraction of the margin by 2^-25. Half the fixed separation is added. A vertex' radius comes on top.
  float margin;
  /// Added where KeptGap compares a distance in floats with a fraction of an earlier one. Rounding hides 2^-23 of
  /// either. No component of a vector between vertices is off by more than 2^-24. A pair's separation in floats is
  /// larger by 2^-22. This covers the distance compared, but is subtracted from the earlier one. Twice the radii come
  /// on top where there are outliers, for the same reason.
  static constexpr float kBlur = 0x1p-21f;
  /// The relative margin of boxes of residuals, times the residual. Rounding to float is off by 2^-24 of it, and so is
  /// the box's own subtraction.
  static constexpr float kRelativeMargin = 0x1p-22f;
  /// The absolute margin, added as well. The speed of a single pair (pair/narrow/kept_distance.hpp) is rounded up by at
  /// most 2 * 40 * 2^-53 of its three sizes. Each is at most 2 here, so this is below 2^-44. Two boxes' margins add up.
  /// No bound from boxes may be sharper than that speed.
  static constexpr float kLeastMargin = 0x1p-44f;
  /// The error that rounding hides of an outlier, relative to the sum of its largest coordinate and its radius.
  /// Rounding to float is off by 2^-24 of it, the box's own subtraction by as much. On an axis with m components 1 or
  /// -1 (load_box_motion) a vertex is off by sqrt(m) 2^-24 of the axis' length.
  static constexpr float kOutlierMargin = 0x1p-22f;
  /// A vertex with coordinates beyond this may be anywhere. Floats hold squares up to far beyond it, 2^63.
  static constexpr double kFarthest = 0x1p40;

  /// Where a vertex starts, and its displacement during the step, in this frame.
  Vec3<double> place(const PackedVertex& vertex) const;
  Vec3<double> displacement(const PackedVertex& vertex) const;
  /// A distance in box coordinates, rounded up with room for later additions. Capped where two boxes that are each
  /// widened by it meet wherever they are.
  float distance(double distance) const;

  friend bool operator==(const BoxFrame&, const BoxFrame&) = default;
};

/// The frame of a scene's vertices, or of the finest of them (fine_place.hpp). Half the separation widens boxes.
BoxFrame frame_of(const SceneVertices& scene, double min_separation);

}  // namespace tamis
