#include "paper/queries/exact_double.hpp"

#include <algorithm>
#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <string>

#include "files/text.hpp"

namespace tamis::lab {
namespace {

using boost::multiprecision::cpp_int, boost::multiprecision::cpp_rational;

bool is_integer(std::string_view word) {
  if (!word.empty() && word[0] == '-') word.remove_prefix(1);
  return !word.empty() && word.find_first_not_of("0123456789") == std::string_view::npos;
}

/// REQUIRES: is_integer(word). A leading zero would mean octal.
cpp_int integer_of(std::string_view word) {
  const auto digits = word.substr(std::min(word.find_first_not_of("-0"), word.size()));
  const cpp_int size(digits.empty() ? "0" : std::string(digits));
  return word[0] == '-' ? cpp_int(-size) : size;
}

/// The common case: both fit in machine words and the division is exact.
std::optional<double> small_fraction(std::string_view numerator, std::string_view denominator) {
  constexpr std::int64_t kExact = std::int64_t{1} << 53;
  const auto n = io::to_integer<std::int64_t>(numerator);
  const auto d = io::to_integer<std::int64_t>(denominator);
  if (!n || !d || *n > kExact || *n < -kExact || *d <= 0 || !std::has_single_bit(static_cast<std::uint64_t>(*d)))
    return std::nullopt;
  return static_cast<double>(*n) / static_cast<double>(*d);
}

}  // namespace

std::optional<double> exact_double(std::string_view numerator, std::string_view denominator) {
  if (const auto value = small_fraction(numerator, denominator)) return value;
  if (!is_integer(numerator) || !is_integer(denominator)) return std::nullopt;
  const cpp_int n = integer_of(numerator), d = integer_of(denominator);
  if (d == 0) return std::nullopt;
  const cpp_rational fraction = cpp_rational(n) / d;
  const auto value = static_cast<double>(fraction);  // the nearest double, hence the comparison
  if (!std::isfinite(value) || fraction != value) return std::nullopt;
  return value;
}

}  // namespace tamis::lab
