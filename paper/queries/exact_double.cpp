#include "paper/queries/exact_double.hpp"

#include <gmpxx.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <string>

#include "files/text.hpp"

namespace tamis::lab {
namespace {

bool is_integer(std::string_view word) {
  if (!word.empty() && word[0] == '-') word.remove_prefix(1);
  return !word.empty() && word.find_first_not_of("0123456789") == std::string_view::npos;
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
  // Base 10 is given because by default a leading zero would mean octal.
  mpq_class fraction(mpz_class(std::string(numerator), 10), mpz_class(std::string(denominator), 10));
  if (fraction.get_den() == 0) return std::nullopt;
  fraction.canonicalize();
  // Values beyond the largest double do not survive get_d(). Others are truncated by it, hence the comparison.
  if (mpz_sizeinbase(fraction.get_num_mpz_t(), 2) > 1024) return std::nullopt;
  const double value = fraction.get_d();
  if (!std::isfinite(value) || mpq_class(value) != fraction) return std::nullopt;
  return value;
}

}  // namespace tamis::lab
