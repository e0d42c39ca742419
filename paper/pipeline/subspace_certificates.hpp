// Subspace min-norm certificates (Barbic, James 2010): for each node of a hierarchy over triangles, a length of q below
// which no two of its triangles without a common vertex can touch, if x = X + U q. With a direction n and vertices a, b
// of the two triangles, n.(x_b - x_a) >= n.(X_b - X_a) - |n^T (U_b - U_a)| |q|. Over the triangles, both terms are
// extreme at vertices: so if |q| is below (least gap) / (greatest |n^T (U_b - U_a)|), the two are apart.
// Barbic and James bound by the pseudoinverse at sampled points and in floating point; here every bound is rounded
// outward, and sound for all directions tried.
#pragma once
#include <limits>
#include <span>
#include <vector>

#include "paper/bvh/binary_tree.hpp"
#include "paper/reduced_model.hpp"

namespace tamis::lab {

class SubspaceCertificates {
 public:
  /// `triangles` are numbered as in the tree. Time: a bound for each pair of triangles that comes near the least one.
  SubspaceCertificates(const BinaryTree& tree, std::span<const Face> triangles, const ReducedModel& model);

  /// One norm for each node. Zero: nothing is proven; infinity: no q brings two triangles of the node together.
  const std::vector<double>& least_norms() const { return least_norms_; }
  /// The certificates hold for positions whose components differ from X + U q by at most this.
  double allowed_residual() const { return 0.5 * allowance_; }
  std::uint64_t memory_bytes() const { return least_norms_.capacity() * sizeof(double); }

 private:
  std::vector<double> least_norms_;
  double allowance_ = 0;  ///< times |n|_1, this is subtracted from every gap
};

}  // namespace tamis::lab
