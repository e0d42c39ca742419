// Columns of numbers as bytes that compress well: neighbours resemble each other, so their differences are small, and
// bytes of one significance stand together.
#pragma once
#include <cstdint>
#include <span>
#include <string>

namespace tamis::io {

/// Element by element least significant byte first, but first the lowest bytes of all elements, then the next ones.
template <class Number>
void append_planes(std::string& bytes, std::span<const Number> column) {
  for (std::size_t byte = 0; byte < sizeof(Number); ++byte)
    for (const Number x : column) bytes += static_cast<char>((x >> (8 * byte)) & 0xff);
}

/// Each row of `width` numbers less the row above it; differences wrap, and are folded so that small ones of either
/// sign have zero bytes above (0, -1, 1, -2 become 0, 1, 2, 3). Then in planes.
void append_differences(std::string& bytes, std::span<const std::uint32_t> column, std::size_t width);

}  // namespace tamis::io
