// The vertices of a step as the kernels read them: one cache line each in doubles for the solver, and floats in a
// common frame for the boxes.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "motion/separations.hpp"
#include "numerics/held_bytes.hpp"
#include "numerics/vec.hpp"
#include "tamis/step.hpp"

namespace tamis {

struct Box;
struct SharedMotion;

/// A vertex at t=0 and t=1: x y z, its radius (Separations), x y z, unused.
struct alignas(64) PackedVertex {
  double at[8];

  const double* start() const { return at; }
  const double* end() const { return at + 4; }
};

/// A vertex in the frame of the boxes, rounded to nearest: x y z at t=0, then at t=1, its radius (rounded up), one
/// unused; half a cache line. For residuals (SharedMotion): zeros, then x y z of the residual.
struct alignas(32) BoxVertex {
  static constexpr int kRadius = 6;
  float at[8] = {};
};

/// box coordinate = (coordinate - origin) * scale: within [-1,1] for every vertex of the step. Scale is a power of
/// two and the origin follows the scene, so the unit of length changes no decision. Where the scene moves far as a
/// whole the frame moves with it, straight from `origin` to `origin_at_end`: motions stay linear, and relative motions
/// the same.
struct BoxFrame {
  std::array<double, 3> origin, origin_at_end;
  double scale;
  double widening;  ///< the scene's width at t=1 over that at t=0; NaN if it is a point at both
  /// Added on each side of a box: rounding to float is off by 2^-25, the subtraction by 2^-53, and the box's own
  /// subtraction of the margin by 2^-25; plus half the fixed separation. A vertex' radius comes on top.
  float margin;
  /// Added where KeptGap compares a distance in floats with a fraction of an earlier one: rounding hides 2^-23 of
  /// either, since no component of a vector between vertices is off by more than 2^-24. A pair's separation in floats
  /// is larger by 2^-22, which covers the distance compared, but is subtracted from the earlier one.
  static constexpr float kBlur = 0x1p-21f;
  /// The same for residuals, times the residual: rounding to float is off by 2^-24 of it, the box's own subtraction by
  /// as much.
  static constexpr float kRelativeMargin = 0x1p-22f;
  /// And added to that: the speed of a single pair (narrow/kept_distance.hpp) is rounded up by at most 2 * 40 * 2^-53
  /// of its three sizes, each at most 2 here: below 2^-44, and two boxes' margins add up. No bound from boxes may be
  /// sharper.
  static constexpr float kLeastMargin = 0x1p-44f;

  /// Where a vertex starts, and how far it goes during the step in this frame.
  Vec3<double> place(const PackedVertex& vertex) const;
  Vec3<double> displacement(const PackedVertex& vertex) const;
};

/// The separation of a pair: a fixed distance, and if there are any the radii that stand beside the vertices.
template <class T>
struct PairSeparation {
  T fixed = 0;
  bool has_radii = false;
};

/// A motion as the kernels see it: in doubles, and in the frame of the boxes.
struct MotionView {
  const PackedVertex* vertices;
  PairSeparation<double> separation = {};
  const BoxVertex* box_vertices = nullptr;
  PairSeparation<float> box_separation = {};  ///< with what rounding may hide: the margins of two boxes
};

struct PackedMotion {
  std::vector<PackedVertex> vertices;
  std::vector<BoxVertex> box_vertices;
  std::vector<BoxVertex> residuals;
  float spread = 0;  ///< the extent of all residuals, summed over the axes
  BoxFrame frame;
  Separations separations;

  /// Loads the vertices `used` and the separations; residuals stay. Returns false if nothing has changed, to the bit.
  /// REQUIRES: as many positions at both ends, and as many radii or none. REQUIRES (not checked: O(n)): a validated
  /// step.
  bool assign(const Step& step, std::span<const Index> used, const Separations& separations);
  /// Computes the residuals of the vertices `used`, what is left of their displacements beside `shared`.
  void assign_residuals(std::span<const Index> used, const SharedMotion& shared);
  MotionView view() const {
    const bool has_radii = !separations.radii.empty();
    return {vertices.data(), {separations.fixed, has_radii}, box_vertices.data(), {2 * frame.margin, has_radii}};
  }
  std::uint64_t memory_bytes() const { return held_bytes(vertices, box_vertices, residuals); }

 private:
  /// Returns the bits in which some vertex differs from what it was.
  std::uint64_t load(std::span<const Index> some, const Step& step);
  /// Returns the box around these residuals.
  Box load_residuals(std::span<const Index> some, const SharedMotion& shared);
};

/// What boxes of vertices, or of residuals, are widened by: so much, and so much of the box's size.
struct BoxMargins {
  float fixed, relative;
};

}  // namespace tamis
