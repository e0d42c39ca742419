// The motion that all vertices of a scene share, an affine map fitted to their displacements. It changes distances by
// its stretch alone. So only the residuals beside it can bring pairs together (docs/numerics/steps.md, "Step lengths").
#pragma once
#include "search/bounds/displacement_gradient.hpp"
#include "tamis/mesh.hpp"

namespace tamis {

struct SharedMotion {
  bool has_gradient = false;
  GradientFit fit = {};   ///< zero without a gradient
  StretchBounds stretch;  ///< of the gradient

  /// A vertex' displacement less the shared motion, in the frame of the boxes.
  Vec3<double> residual_of(const PackedVertex& vertex, const BoxFrame& frame) const {
    return frame.displacement(vertex) - fit.mean_displacement -
           fit.gradient.at(frame.place(vertex) - fit.mean_position);
  }
};

/// Fits the gradient. Returns no gradient unless its residuals are less likely than the displacements themselves to
/// bring pairs to `fraction` of their distance.
SharedMotion fit_shared_motion(const Mesh& mesh, const PackedMotion& motion, double fraction);

}  // namespace tamis
