// Colours of times of impact: early is bright, late is dark, as in the viewer.
#pragma once
#include <array>
#include <cstdint>

namespace tamis::io {

using Rgb = std::array<std::uint8_t, 3>;

/// Plasma (Smith and van der Walt), which a colour-blind person reads as well: its lightness falls all the way.
/// REQUIRES: 0 <= time <= 1. sRGB.
Rgb colour_of_time(double time);

}  // namespace tamis::io
