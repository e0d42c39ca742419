// The order of features in a block tree.
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

#include "numerics/raw_array.hpp"
#include "tamis/mesh.hpp"

namespace tamis {

/// Centers of features, [axis], and whose they are: parallel arrays. Three axes, or six: where the centers are at
/// OrderAxes::time, then OrderAxes::way of how far they go.
struct Centers {
  static constexpr int kMostAxes = 6;
  float* at[kMostAxes];
  Index* feature;
  int axes;

  Centers from(std::size_t first) const {
    Centers rest = *this;
    for (float*& axis : rest.at) axis += axis ? first : 0;
    rest.feature += first;
    return rest;
  }
};

/// Centers reach no farther along each axis.
struct Reach {
  float along[Centers::kMostAxes];
};
struct PartsReach {
  Reach low, high;
};

/// Splits `count` centers along their longest axis. The `lower` ones that come first (of equal ones those in front)
/// move to the front of `centers`, the others to `scratch`, from place `lower` on; both stay in their order. What else
/// lies before place `count` is lost. `reach`: of all. REQUIRES (not checked: each): finite coordinates; 0 < lower <
/// count. One of the kernels.
using Split = PartsReach (*)(const Centers& centers, const Centers& scratch, std::size_t count, std::size_t lower,
                             Reach reach);

/// Called now and then, from several threads; what it throws ends the work.
using Pause = std::function<void()>;

/// Memory for centers, not set.
class CenterStore {
 public:
  CenterStore(std::size_t count, int axes);
  Centers view();
  std::span<const Index> features() const { return features_.all(); }

 private:
  int axes_;
  RawArray<float> at_;  ///< axis after axis
  RawArray<Index> features_;
};

/// Orders the features of centers, whose coordinates are lost, such that every sixteen, and every sixteen times
/// sixteen, and so on, lie close together: halved again and again along the longest axis. Costs more than a Morton
/// order, and saves as much on every question (docs/history/performance.md). The same for any number of threads.
/// `ends`: where centers come in groups, ascending, the places at which these end; they stay one after the other.
void order_in_space(const Centers& centers, std::size_t count, Split split, const Pause& pause,
                    std::span<const std::size_t> ends = {});

}  // namespace tamis
