// The numbers that an option takes.
#pragma once
#include <limits>
#include <string>

namespace tamis::cli {

/// From `least` to `most`.
template <class T>
struct NumberRange {
  T least = std::numeric_limits<T>::lowest();
  T most = std::numeric_limits<T>::max();
  bool takes_most = true;  ///< false: smaller than `most`
};

inline constexpr NumberRange<double> kNotNegative{.least = 0};

/// The number that `text` is, written in decimal; throws InvalidOptions, which names the option: also if it is empty (a
/// variable of the shell that is not set), NaN, infinite or out of range. T is int, std::uint64_t or double.
template <class T>
T number_from(const std::string& option, const std::string& text, const NumberRange<T>& range);

/// "S >= 0", "N from 1 to 9": how the help shows what an option called `letter` takes.
template <class T>
std::string shown_range(const std::string& letter, const NumberRange<T>& range);

}  // namespace tamis::cli
