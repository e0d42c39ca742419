// The order of features in a block tree.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tamis/mesh.hpp"

namespace tamis {

/// Centers of features, [axis], and whose they are: parallel arrays.
struct Centers {
  float* at[3];
  Index* feature;

  Centers from(std::size_t first) const { return {{at[0] + first, at[1] + first, at[2] + first}, feature + first}; }
};

/// Puts the `lower` of `count` centers that come first along their longest axis in front, in an order that depends on
/// the centers alone. `scratch` has room for `count`. One of the kernels.
using Split = void (*)(const Centers& centers, const Centers& scratch, std::size_t count, std::size_t lower);

/// Memory for centers.
class CenterStore {
 public:
  explicit CenterStore(std::size_t count);
  Centers view();
  std::span<const Index> features() const { return features_; }

 private:
  std::vector<float> at_[3];
  std::vector<Index> features_;
};

/// Orders centers such that every sixteen, and every sixteen times sixteen, and so on, lie close together: halved
/// again and again along the longest axis. Costs more than a Morton order, and saves as much on every question
/// (docs/performance.md). The same for any number of threads.
void order_in_space(const Centers& centers, std::size_t count, Split split);

}  // namespace tamis
