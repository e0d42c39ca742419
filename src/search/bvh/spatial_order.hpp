// Orders features in space, so that every block of a tree over them is compact.
#pragma once
#include <cstddef>
#include <functional>
#include <span>

#include "numbers/raw_array.hpp"
#include "tamis/mesh.hpp"

namespace tamis {

/// Coordinates of feature centers, [axis], and the features' numbers: parallel arrays. Three axes, the positions at
/// OrderAxes::time, or six: then their displacements, too, times OrderAxes::displacement_weight.
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

/// Upper bounds of the extents of some centers.
struct ExtentBounds {
  float along[Centers::kMostAxes];  ///< each axis
};
struct HalvesExtents {
  ExtentBounds low, high;
};

/// Splits `count` centers along their longest axis, in a stable way: the `lower` lowest move to the front of `centers`,
/// the others to `scratch`, from place `lower` on. The rest of both, up to place `count`, is overwritten. `extents`: of
/// all centers. REQUIRES (not checked: O(n)): finite coordinates; 0 < lower < count. One of the kernels.
using Split = HalvesExtents (*)(const Centers& centers, const Centers& scratch, std::size_t count, std::size_t lower,
                                ExtentBounds extents);

/// Called now and then, from several threads; an exception that it throws ends the work.
using Pause = std::function<void()>;

/// Memory for centers, not initialized.
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

/// Orders the features such that every sixteen, every sixteen times sixteen, and so on, lie close together: by halving
/// again and again along the longest axis. Overwrites the coordinates. Costs more than a Morton order, and saves as
/// much on every question (docs/history/performance.md). The order does not depend on the number of threads. `ends`: if
/// the centers are in groups, the places at which these end, ascending; groups stay one after the other.
void order_in_space(const Centers& centers, std::size_t count, Split split, const Pause& pause,
                    std::span<const std::size_t> ends = {});

}  // namespace tamis
