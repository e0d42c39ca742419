// Values of an enumeration and their names, as a user writes them.
#pragma once
#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "tamis/error.hpp"
#include "tamis/options.hpp"

namespace tamis {

template <class Enum, std::size_t n>
using EnumNames = std::array<std::pair<Enum, std::string_view>, n>;

/// `what`: names the enumeration in the error. Throws InvalidOptions, naming the choices, if there is no such name.
template <class Enum, std::size_t n>
Enum find_by_name(const EnumNames<Enum, n>& names, std::string_view what, std::string_view name) {
  std::string choices;
  for (const auto& [value, text] : names) {
    if (text == name) return value;
    choices += (choices.empty() ? "" : ", ") + std::string(text);
  }
  throw InvalidOptions("unknown " + std::string(what) + " '" + std::string(name) + "': use one of " + choices);
}

/// kUnnamed if `value` is none of the enumeration's.
template <class Enum, std::size_t n>
std::string_view find_name(const EnumNames<Enum, n>& names, Enum value) {
  for (const auto& [key, text] : names)
    if (key == value) return text;
  return kUnnamed;
}

/// Throws InvalidOptions if `value` is none of the enumeration's.
template <class Enum>
void validate_is_named(Enum value, std::string_view what) {
  if (name_of(value) == kUnnamed)
    throw InvalidOptions("unknown " + std::string(what) + " number " + std::to_string(static_cast<int>(value)) +
                         ": use one of the enumeration's names");
}

}  // namespace tamis
