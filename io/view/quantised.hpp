// Positions as integers over the box of all frames.
#pragma once
#include <cstdint>
#include <vector>

#include "io/view/recording.hpp"

namespace tamis::io {

struct QuantisedFrames {
  Point lowest{};
  double spacing = 1;  ///< of the grid: position = lowest + spacing * integer
  double error = 0;    ///< largest |component| of a rounding error, over all frames
  std::vector<std::vector<std::uint32_t>> frames;
};

/// Is the box of all frames no larger than half the largest double, so that nothing here overflows?
bool can_quantise(const Recording& recording);

/// REQUIRES: can_quantise(recording). Vertices that nothing uses are put at `lowest`: their positions may be anything.
QuantisedFrames quantise(const Recording& recording);

}  // namespace tamis::io
