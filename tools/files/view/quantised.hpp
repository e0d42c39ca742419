// Positions as integers over the box of all frames.
#pragma once
#include <cstdint>
#include <string_view>
#include <vector>

#include "files/view/recording.hpp"

namespace tamis::io {

struct QuantisedFrames {
  Point lowest{};
  double spacing = 1;  ///< of the grid: position = lowest + spacing * integer
  double error = 0;    ///< largest |component| of a rounding error, over all frames
  std::vector<std::vector<std::uint32_t>> frames;
};

/// Why the box of all frames is too large or too small for numbers of the grid; empty if it is not.
std::string_view why_not_quantised(const Recording& recording);

/// REQUIRES: why_not_quantised(recording) is empty. Vertices that nothing uses are put at `lowest`: their positions may
/// be anything.
QuantisedFrames quantise(const Recording& recording);

}  // namespace tamis::io
