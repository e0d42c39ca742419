// Converts a fraction of two integers to a double, if that is exact.
#pragma once
#include <optional>
#include <string_view>

namespace tamis::lab {

/// The double equal to numerator / denominator, two decimal integers of any length. None if a word is no integer, the
/// denominator is 0, or no double has exactly this value.
std::optional<double> exact_double(std::string_view numerator, std::string_view denominator);

}  // namespace tamis::lab
