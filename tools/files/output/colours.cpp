#include "files/output/colours.hpp"

#include <algorithm>
#include <cmath>

namespace tamis::io {

Rgb colour_of_time(double time) {
  constexpr std::array<Rgb, 11> kPlasma{{{0xf0, 0xf9, 0x21},
                                         {0xfb, 0xd5, 0x24},
                                         {0xfd, 0xb4, 0x2f},
                                         {0xf8, 0x95, 0x40},
                                         {0xed, 0x79, 0x53},
                                         {0xde, 0x5f, 0x65},
                                         {0xcc, 0x47, 0x78},
                                         {0xb5, 0x2f, 0x8c},
                                         {0x9c, 0x17, 0x9e},
                                         {0x7e, 0x03, 0xa8},
                                         {0x5c, 0x01, 0xa6}}};
  const double place = time * static_cast<double>(kPlasma.size() - 1);
  const std::size_t below = std::min(static_cast<std::size_t>(place), kPlasma.size() - 2);
  const double part = place - static_cast<double>(below);
  Rgb colour{};
  for (std::size_t i = 0; i < colour.size(); ++i)
    colour[i] = static_cast<std::uint8_t>(std::lround((1 - part) * kPlasma[below][i] + part * kPlasma[below + 1][i]));
  return colour;
}

Rgb colour_of_object(std::size_t object) {
  constexpr std::array<Rgb, 6> kColours{{{0x8b, 0xa3, 0xc4},
                                         {0xc9, 0xbd, 0xa4},
                                         {0x8f, 0xb5, 0xac},
                                         {0xb9, 0xa6, 0xc2},
                                         {0xb8, 0xc0, 0xc8},
                                         {0xa9, 0xb1, 0x8c}}};
  return kColours[object % kColours.size()];
}

}  // namespace tamis::io
