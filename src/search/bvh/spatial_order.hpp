// Orders features in space, so every block of a tree over them is compact.
#pragma once
#include <cstddef>
#include <functional>
#include <span>

#include "tamis/mesh.hpp"

namespace tamis {

/// The center of a feature. Three axes: its position at OrderAxes::time. Six axes: also its displacement times
/// OrderAxes::displacement_weight. Aligned, so a center is copied as a whole.
template <int axes>
struct alignas(16) Center {
  float at[axes];
  Index feature;
};

/// Called now and then, from several threads. An exception that it throws ends the work.
using Pause = std::function<void()>;

/// Orders centers such that every sixteen, every sixteen times sixteen, and so on, lie close together. Halves them
/// again and again along their longest axis. With a Morton order all
/// later searches take 1.32 times as long. `ends`: if the centers are in groups, the places at which these end,
/// ascending. Groups stay one after the other. The order does not depend on the number of threads. REQUIRES (not
/// checked: O(n)): finite coordinates. Three or six axes.
template <int axes>
void order_in_space(std::span<Center<axes>> centers, const Pause& pause, std::span<const std::size_t> ends = {});

}  // namespace tamis
