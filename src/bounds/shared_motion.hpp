// What all vertices of a scene have in common in how they move in a step: turned or stretched as a whole, they lose no
// more of their distances than that takes (docs/numerics.md, "Step lengths").
#pragma once
#include "bounds/displacement_gradient.hpp"
#include "tamis/mesh.hpp"

namespace tamis {

class SharedMotion {
 public:
  /// Keeps a reference.
  explicit SharedMotion(const Mesh& mesh) : mesh_(mesh) {}

  /// Takes the scene's gradient if less is left beside it that may bring near pairs to `fraction` of their distance;
  /// else none.
  void fit(const Step& step, const BoxFrame& frame, double fraction);

  struct Stretch : StretchBounds {
    bool is_any = false;  ///< is there a gradient?
  };
  const Stretch& stretch() const { return stretch_; }
  /// f(vertex, residual) for all that take part in contacts, in the frame of the boxes.
  template <class F>
  void for_each_residual(const Step& step, const BoxFrame& frame, const F& f) const {
    for (const Index v : mesh_.points())
      f(v, frame.displacement(step, v) - fit_.way - fit_.gradient.at(frame.place(step.start, v) - fit_.middle));
  }

 private:
  const Mesh& mesh_;
  GradientFit fit_{};
  Stretch stretch_;
};

}  // namespace tamis
