// Numbers in error messages.
#pragma once
#include <array>
#include <charconv>
#include <string>

namespace tamis {

/// The shortest text that reads back as the same double: std::to_string(-1e-9) is "-0.000000".
inline std::string number_text(double number) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), number).ptr};
}

}  // namespace tamis
