// Columns of numbers as bytes that compress well: neighbours resemble each other, so their differences are small, and
// bytes of one significance stand together.
#pragma once
#include <cstdint>
#include <span>
#include <string>

namespace tamis::io {

/// Appends the lowest bytes of all elements, then their next bytes, and so on to the highest.
template <class Number>
void append_planes(std::string& bytes, std::span<const Number> column) {
  for (std::size_t byte = 0; byte < sizeof(Number); ++byte)
    for (const Number x : column) bytes += static_cast<char>((x >> (8 * byte)) & 0xff);
}

/// Appends, in planes, each row of `width` numbers less the row above it. Differences wrap, and are folded so that
/// small ones of either sign have high bytes of zero (0, -1, 1, -2 become 0, 1, 2, 3).
void append_differences(std::string& bytes, std::span<const std::uint32_t> column, std::size_t width);

}  // namespace tamis::io
