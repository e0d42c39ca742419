#include "files/text.hpp"

#include <clocale>
#include <cstdlib>
#include <string>

namespace tamis::io {
namespace {

/// strtod() in the "C" locale, whatever locale the program has set: in those of many countries strtod() stops at the
/// decimal point.
double plain_number(const std::string& word) {
  static const locale_t plain = newlocale(LC_ALL_MASK, "C", nullptr);
  return strtod_l(word.c_str(), nullptr, plain);
}

}  // namespace

std::optional<double> to_double(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size() || error == std::errc::invalid_argument) return std::nullopt;
  // Out of range, from_chars leaves the value unchanged; strtod tells overflow from underflow.
  if (error == std::errc::result_out_of_range) value = plain_number(std::string(word));
  return value;
}

}  // namespace tamis::io
