// The motion that all vertices of a scene share, an affine map fitted to their displacements: it changes distances by
// its stretch alone, so that only the residuals beside it can bring pairs together (docs/numerics.md, "Step lengths").
#pragma once
#include "bounds/displacement_gradient.hpp"
#include "tamis/mesh.hpp"

namespace tamis {

class SharedMotion {
 public:
  /// Keeps a reference.
  explicit SharedMotion(const Mesh& mesh) : mesh_(mesh) {}

  /// Fits the gradient of the step; drops it unless the residuals are less likely to bring pairs to `fraction` of their
  /// distance than the displacements themselves.
  void fit(const Step& step, const BoxFrame& frame, double fraction);

  struct Stretch : StretchBounds {
    bool is_any = false;  ///< is there a gradient?
  };
  const Stretch& stretch() const { return stretch_; }
  /// Calls f(vertex, residual) for all vertices that take part in contacts, in the frame of the boxes.
  template <class F>
  void for_each_residual(const Step& step, const BoxFrame& frame, const F& f) const {
    for (const Index v : mesh_.points())
      f(v, frame.displacement(step, v) - fit_.mean_displacement -
               fit_.gradient.at(frame.place(step.start, v) - fit_.mean_position));
  }

 private:
  const Mesh& mesh_;
  GradientFit fit_{};
  Stretch stretch_;
};

}  // namespace tamis
