// A fraction of two integers as the double it is, or not at all.
#pragma once
#include <optional>
#include <string_view>

namespace tamis::lab {

/// The double equal to numerator / denominator, decimal integers of any length; none if a word is no integer, the
/// denominator is 0, or no double has exactly this value.
std::optional<double> exact_double(std::string_view numerator, std::string_view denominator);

}  // namespace tamis::lab
