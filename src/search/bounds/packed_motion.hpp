// The vertices of a step as the kernels read them. Each has one cache line of doubles for the solver, and floats in a
// common frame for the boxes.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "numbers/held_bytes.hpp"
#include "pair/motion/separations.hpp"
#include "search/bounds/box_frame.hpp"
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

/// A vertex in the frame of the boxes, rounded to nearest: x y z at t=0, then at t=1, its radius (rounded up; for an
/// outlier, with what rounding hides of it added), one unused; half a cache line. For residuals (SharedMotion): zeros,
/// then x y z of the residual, and for an outlier what rounding hides instead of the radius.
struct alignas(32) BoxVertex {
  static constexpr int kRadius = 6;
  float at[8] = {};

  float largest_coordinate() const {
    float largest = 0;
    for (int k = 0; k < kRadius; ++k) largest = std::max(largest, std::fabs(at[k]));
    return largest;
  }
};

/// The separation of a pair: a fixed distance, and if `has_radii` the radii that are stored with the vertices.
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
  PairSeparation<float> box_separation = {};  ///< the margins of two boxes: the separation, and what rounding may hide
  bool has_outliers = false;                  ///< BoxFrame::has_outliers
};

struct PackedMotion {
  std::vector<PackedVertex> vertices;
  std::vector<BoxVertex> box_vertices;
  std::vector<BoxVertex> residuals;
  float spread = 0;  ///< the extent of all residuals but outliers', summed over the axes
  BoxFrame frame{};
  Separations separations;

  /// Loads the vertices `used` and the separations; residuals stay. `of_scene`: the frame, if the vertices are part of
  /// a larger scene; null: the frame of the vertices. Returns false if no bit of all these has changed. REQUIRES: the
  /// same number of positions at both ends, and of radii unless there are none. REQUIRES (not checked: O(n)): a
  /// validated step. Its vertices are among the vertices that made `of_scene`.
  bool assign(const Step& step, std::span<const Index> used, const Separations& separations,
              const BoxFrame* of_scene = nullptr);
  /// Computes the residuals of the vertices `used`: their displacements less the motion `shared`.
  void assign_residuals(std::span<const Index> used, const SharedMotion& shared);
  /// True if the vertex lies outside the frame.
  bool is_outlier(Index vertex) const {
    return frame.has_outliers && box_vertices[static_cast<std::size_t>(vertex)].largest_coordinate() > 1;
  }
  MotionView view() const {
    const bool has_radii = !separations.radii.empty();
    return {vertices.data(),
            {separations.fixed, has_radii},
            box_vertices.data(),
            {2 * frame.margin, has_radii || frame.has_outliers},
            frame.has_outliers};
  }
  std::uint64_t memory_bytes() const { return held_bytes(vertices, box_vertices, residuals); }

 private:
  /// Returns the bits that differ in some vertex. `has_outliers`: of the frame.
  template <bool has_outliers>
  std::uint64_t load(std::span<const Index> some, const Step& step);
  /// Returns the box around these residuals, without outliers.
  Box load_residuals(std::span<const Index> some, const SharedMotion& shared);
};

/// What widens boxes of vertices, or of residuals: `fixed`, and `relative` times the larger distance of an end from
/// zero.
struct BoxMargins {
  float fixed, relative;
};

}  // namespace tamis
