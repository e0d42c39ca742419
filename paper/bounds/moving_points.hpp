// The vertices of a step, brought to one scale, so that no overflow is possible and bounds may be kept in float.
#pragma once
#include <vector>

#include "numbers/assert.hpp"
#include "numbers/scale.hpp"
#include "pair/motion/pair_kinds.hpp"
#include "pair/motion/pair_motion.hpp"
#include "tamis/mesh.hpp"
#include "tamis/step.hpp"

namespace tamis::lab {

/// Any finite double times its scale_below_one() is smaller than this.
inline constexpr double kLargestScaled = 4;

/// Positions times a power of two: the largest |coordinate| of the vertices in use lies in [1/2, 1), or as near to that
/// as scale_below_one() brings it: below kLargestScaled.
class MovingPoints {
 public:
  /// REQUIRES: as many positions as the mesh has vertices. REQUIRES (not checked: O(n)): a validated step. Vertices
  /// that take no part in contacts are left at zero.
  void update(const Mesh& mesh, const Step& step);

  const Moving<double>& operator[](Index vertex) const { return points_[static_cast<std::size_t>(vertex)]; }
  Index count() const { return static_cast<Index>(points_.size()); }
  /// The power of two: times a length of the step, it gives a length here.
  double scale() const { return scale_; }
  /// Approximate middle of the box of all positions. Bounds are kept relative to it.
  const Vec3<double>& centre() const { return centre_; }
  std::uint64_t memory_bytes() const { return points_.capacity() * sizeof(points_[0]); }

 private:
  std::vector<Moving<double>> points_;
  double scale_ = 1;
  Vec3<double> centre_{0, 0, 0};
};

/// The pair's motion with its sizes. REQUIRES: coordinates of MovingPoints. vf: p, a, b, c; ee: a0, a1, b0,
/// b1.
template <PairKind kind>
inline PairMotion<double> relative_motion(const Moving<double>& p0, const Moving<double>& p1, const Moving<double>& p2,
                                          const Moving<double>& p3) {
  TAMIS_ASSERT(largest(p0) < kLargestScaled && largest(p1) < kLargestScaled);
  TAMIS_ASSERT(largest(p2) < kLargestScaled && largest(p3) < kLargestScaled);
  const Moving<double>* points[] = {&p0, &p1, &p2, &p3};
  const auto moving = [&](VertexDifference v) { return *points[v.to] - *points[v.from]; };
  constexpr SpanningVectors kVectors = spanning_vectors(kind);
  const auto e = moving(kVectors.e), f = moving(kVectors.f), d = moving(kVectors.d);
  return {e, f, d, largest(e), largest(f), largest(d)};
}

}  // namespace tamis::lab
