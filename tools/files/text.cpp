#include "files/text.hpp"

#include <cstdint>
#include <limits>

// Standard libraries that read no doubles (libc++ before 20) say so by not having this macro.
#if defined(__cpp_lib_to_chars)
namespace number_reader = std;
#elif __has_include(<fast_float/fast_float.h>)
#include <fast_float/fast_float.h>
namespace number_reader = fast_float;
#else
#error "this standard library reads no doubles (std::from_chars): install fast_float (Debian: libfast-float-dev)"
#endif

namespace tamis::io {
namespace {

/// What a decimal number that no double is near rounds to: 0 or infinity, with its sign. Tells by the place of its
/// first digit, which is hundreds of places from the point.
double beyond_doubles(std::string_view word) {
  const std::size_t digits_end = std::min(word.find_first_of("eE"), word.size());
  const std::size_t point = std::min(word.find('.'), digits_end);
  const std::size_t first_digit = word.find_first_of("123456789");
  std::int64_t place = static_cast<std::int64_t>(point) - static_cast<std::int64_t>(first_digit);
  if (digits_end < word.size()) {
    const std::string_view exponent = word.substr(digits_end + 1);
    constexpr auto kFarOff = std::numeric_limits<std::int32_t>::max();
    place += to_integer<std::int32_t>(exponent).value_or(exponent.starts_with('-') ? -kFarOff : kFarOff);
  }
  const double size = place > 0 ? std::numeric_limits<double>::infinity() : 0;
  return word.starts_with('-') ? -size : size;
}

}  // namespace

std::optional<double> to_double(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  double value = 0;
  const auto [end, error] = number_reader::from_chars(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size() || error == std::errc::invalid_argument) return std::nullopt;
  return error == std::errc::result_out_of_range ? beyond_doubles(word) : value;
}

}  // namespace tamis::io
