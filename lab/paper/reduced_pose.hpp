// Where a step is in a reduced model: how long its coordinates q are, and how far its positions are from X + U q.
#pragma once
#include <vector>

#include "lab/reduced_model.hpp"

namespace tamis::lab {

/// Bounds that hold for the exact values. Not finite or NaN if nothing can be said.
struct ReducedPose {
  double norm;      ///< Euclidean length of q, at most
  double residual;  ///< largest |component| of x - (X + U q), at most
};

/// Finds q by least squares; what it finds is verified, so that any q is sound.
class PoseFinder {
 public:
  explicit PoseFinder(const ReducedModel& model);

  ReducedPose pose_of(Positions x) const;

  std::uint64_t memory_bytes() const { return factor_.capacity() * sizeof(double); }

 private:
  std::vector<double> project(Positions x, const std::vector<double>& q) const;
  void solve(std::vector<double>& b) const;
  double residual(Positions x, const std::vector<double>& q) const;

  const ReducedModel& model_;
  std::vector<double> factor_;  ///< Cholesky factor of U^T U + a little, lower triangle, r x r
};

}  // namespace tamis::lab
