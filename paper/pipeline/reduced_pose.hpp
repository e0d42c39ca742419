// Where a pose is in a reduced model: how long its coordinates q are, and how far its positions are from X + U q.
#pragma once
#include <vector>

#include "paper/reduced_model.hpp"

namespace tamis::lab {

/// Upper bounds, rounding included. Infinite or NaN if there is no bound.
struct ReducedPose {
  double norm;      ///< bounds the Euclidean length of q
  double residual;  ///< bounds the largest |component| of x - (X + U q)
};

/// Finds q by least squares, then bounds its residual: so the bounds are sound for any q.
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
  std::vector<double> factor_;  ///< Cholesky factor of U^T U plus a ridge, lower triangle, r x r
};

}  // namespace tamis::lab
