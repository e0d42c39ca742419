#include "command/command_line/number_range.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <optional>
#include <type_traits>

#include "files/error.hpp"
#include "files/text.hpp"
#include "tamis/error.hpp"

namespace tamis::cli {
namespace {

template <class T>
std::optional<T> read_number(const std::string& text) {
  if constexpr (!std::is_floating_point_v<T>) {
    return io::to_integer<T>(text);
  } else {
    const std::optional<double> value = io::to_double(text);
    return value && std::isfinite(*value) ? value : std::nullopt;
  }
}

/// The words that follow the word for the number: ">= 0 and < 1", "from 1 to 9"; empty if there is no bound.
template <class T>
std::string bounds_of(const NumberRange<T>& range) {
  const bool is_bounded_below = range.least > std::numeric_limits<T>::lowest() || !std::is_signed_v<T>;
  const bool is_bounded_above = range.most < std::numeric_limits<T>::max();
  if (is_bounded_below && is_bounded_above && range.takes_most)
    return fmt::format(" from {} to {}", range.least, range.most);
  std::string text;
  if (is_bounded_below) text += fmt::format(" >= {}", range.least);
  if (is_bounded_above)
    text += fmt::format("{} {} {}", is_bounded_below ? " and" : "", range.takes_most ? "<=" : "<", range.most);
  return text;
}

template <class T>
bool takes(const NumberRange<T>& range, T value) {
  return value >= range.least && (range.takes_most ? value <= range.most : value < range.most);
}

}  // namespace

template <class T>
T number_from(const std::string& option, const std::string& text, const NumberRange<T>& range) {
  const auto value = read_number<T>(text);
  if (value && takes(range, *value)) return *value;
  throw InvalidOptions(fmt::format("{}: {} is not a {}number{}: correct it", option,
                                   text.empty() ? "an empty value" : io::in_quotes(text),
                                   std::is_floating_point_v<T> ? "" : "whole ", bounds_of(range)));
}

template <class T>
std::string shown_range(const std::string& letter, const NumberRange<T>& range) {
  return letter + bounds_of(range);
}

template int number_from(const std::string&, const std::string&, const NumberRange<int>&);
template double number_from(const std::string&, const std::string&, const NumberRange<double>&);
template std::uint64_t number_from(const std::string&, const std::string&, const NumberRange<std::uint64_t>&);
template std::string shown_range(const std::string&, const NumberRange<int>&);
template std::string shown_range(const std::string&, const NumberRange<double>&);
template std::string shown_range(const std::string&, const NumberRange<std::uint64_t>&);

}  // namespace tamis::cli
