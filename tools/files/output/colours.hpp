// The viewer's colours, here for other outputs; tools/viewer/test/colours.test.ts compares the two.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

namespace tamis::io {

using Rgb = std::array<std::uint8_t, 3>;

/// Of a time of impact: early is bright, late is dark. Plasma (Smith and van der Walt), which a colour-blind person
/// reads as well: its lightness falls all the way. REQUIRES: 0 <= time <= 1. sRGB.
Rgb colour_of_time(double time);

/// Of an object by its number >= 0: a few muted ones in turn. sRGB.
Rgb colour_of_object(std::size_t object);

}  // namespace tamis::io
