// What all vertices of a scene, or those of objects that move alike, have in common in how they move in a step: turned
// or stretched as a whole, they lose no more of their distances than that takes (docs/numerics.md, "Step lengths").
#pragma once
#include <cstdint>
#include <vector>

#include "bounds/displacement_gradient.hpp"
#include "tamis/mesh.hpp"

namespace tamis {

class SharedMotion {
 public:
  explicit SharedMotion(const Mesh& mesh);

  /// Takes the gradients beside which the least is left that may bring pairs to `fraction` of their distance: that of
  /// the scene, one for all objects that move alike, or none.
  void fit(const Step& step, const BoxFrame& frame, double fraction);

  /// Of all gradients, if there are any.
  struct Stretch : StretchBounds {
    bool is_any = false;
  };
  const Stretch& stretch() const { return stretch_; }
  /// f(vertex, residual) for all that take part in contacts, in the frame of the boxes. Residuals of two objects that
  /// have other gradients differ by no less than displacements do.
  template <class F>
  void for_each_residual(const Step& step, const BoxFrame& frame, const F& f) const {
    for (const Part& part : parts_)
      for (const Index v : part.vertices) {
        const Vec3<double> residual = part.residual(frame.place(step.start, v), frame.displacement(step, v));
        f(v, Vec3<double>{residual.x + part.offset, residual.y, residual.z});
      }
  }

  std::uint64_t memory_bytes() const;

 private:
  struct Part {
    std::span<const Index> vertices;
    GradientFit fit{};
    double offset = 0;

    Vec3<double> residual(const Vec3<double>& place, const Vec3<double>& way) const {
      return way - fit.way - fit.gradient.at(place - fit.middle);
    }
  };
  /// Objects that move alike, and how.
  struct Motion {
    std::vector<std::size_t> objects;
    DisplacementMoments moments;
  };
  /// The sum of the squares of the vertices' residuals, as much as they count.
  struct Fit {
    std::vector<GradientFit> fits;  ///< of each motion
    StretchBounds stretch;
    double residual2 = 0;
  };

  /// From one vertex of an object that is looked at to the next.
  std::size_t stride() const;
  /// Without the stretch where that leaves `most_residual2` or more in any case.
  static Fit fit_to(std::span<const Motion> motions, double fraction, double most_residual2);
  /// None if there are too many.
  std::vector<Motion> motions_of_objects(std::span<const DisplacementMoments> objects, double most_residual2) const;
  void take(std::span<const Motion> motions, const Fit& fit);
  /// Do few pairs of vertices of two motions lie near?
  bool lie_apart(std::span<const Motion> motions, const Fit& fit, const Step& step, const BoxFrame& frame) const;
  void keep_apart(std::span<const Motion> motions, const Step& step, const BoxFrame& frame);

  std::vector<std::vector<Index>> objects_;  ///< the vertices of each, large ones first
  std::size_t vertex_count_ = 0;             ///< of all of them
  std::vector<Part> parts_;                  ///< of each object
  Stretch stretch_;
};

}  // namespace tamis
