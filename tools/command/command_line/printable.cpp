#include "command/command_line/printable.hpp"

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace tamis::cli {
namespace {

struct Character {
  std::size_t size = 0;  ///< in bytes; 0: the text does not begin with a character
  std::uint32_t code = 0;
};

std::uint32_t byte_at(std::string_view text, std::size_t i) { return static_cast<unsigned char>(text[i]); }

/// The first character. Overlong forms, surrogates and codes past U+10FFFF are none (RFC 3629).
Character first_character(std::string_view text) {
  constexpr std::array<std::uint32_t, 5> kLeast{0, 0, 0x80, 0x800, 0x10000};
  const std::uint32_t lead = byte_at(text, 0);
  if (lead < 0x80) return {1, lead};
  const std::size_t size = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if (lead < 0xc0 || lead > 0xf7 || text.size() < size) return {};
  std::uint32_t code = lead & (0x7fU >> size);
  for (std::size_t i = 1; i < size; ++i) {
    if ((byte_at(text, i) & 0xc0U) != 0x80) return {};
    code = code << 6U | (byte_at(text, i) & 0x3fU);
  }
  const bool is_character = code >= kLeast[size] && code <= 0x10ffff && (code < 0xd800 || code > 0xdfff);
  return is_character ? Character{size, code} : Character{};
}

bool is_control(std::uint32_t code) { return code < 0x20 || (code >= 0x7f && code < 0xa0); }

std::string escaped(std::string_view bytes, bool keeps_controls) {
  std::string text;
  while (!bytes.empty()) {
    const Character c = first_character(bytes);
    const std::size_t size = c.size == 0 ? 1 : c.size;
    if (c.size == 0 || (is_control(c.code) && !keeps_controls))
      for (std::size_t i = 0; i < size; ++i) text += fmt::format("\\x{:02x}", byte_at(bytes, i));
    else
      text += bytes.substr(0, size);
    bytes.remove_prefix(size);
  }
  return text;
}

}  // namespace

std::string utf8_text(std::string_view bytes) { return escaped(bytes, true); }

std::string printable(std::string_view bytes) { return escaped(bytes, false); }

}  // namespace tamis::cli
