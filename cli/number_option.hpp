// Options that hold numbers. Every value is looked at while the command line is read, before any file is: an empty one
// (a variable of the shell that is not set), NaN, infinity, words and numbers out of range are refused.
#pragma once
#include <CLI/CLI.hpp>
#include <limits>
#include <string>
#include <vector>

namespace tamis::cli {

/// The numbers that an option takes: from `least` to `most`.
template <class T>
struct NumberRange {
  T least = std::numeric_limits<T>::lowest();
  T most = std::numeric_limits<T>::max();
  bool takes_most = true;  ///< false: smaller than `most`
};

inline constexpr NumberRange<double> kNotNegative{.least = 0};

/// The number that `text` is, written in decimal; throws CLI::ValidationError, which names the option. T is int,
/// std::uint64_t or double.
template <class T>
T number_from(const std::string& option, const std::string& text, const NumberRange<T>& range);

/// "S >= 0", "N from 1 to 9": how the help shows what an option called `letter` takes.
template <class T>
std::string shown_range(const std::string& letter, const NumberRange<T>& range);

/// The parts between commas, empty ones too.
std::vector<std::string> split_list(const std::string& text);

/// `--name 3`.
template <class T>
CLI::Option* add_number(CLI::App& app, const std::string& name, const std::string& letter, T& value,
                        const NumberRange<T>& range, const std::string& help) {
  const auto read = [&value, name, range](const CLI::results_t& texts) {
    value = number_from(name, texts.back(), range);
    return true;
  };
  return app.add_option(name, read, help)->type_name(shown_range(letter, range));
}

/// `--name 1,2,3`, or `--name 1 --name 2`.
template <class T>
CLI::Option* add_numbers(CLI::App& app, const std::string& name, const std::string& letter, std::vector<T>& values,
                         const NumberRange<T>& range, const std::string& help) {
  const auto read = [&values, name, range](const CLI::results_t& texts) {
    values.clear();
    for (const std::string& text : texts)
      for (const std::string& part : split_list(text)) values.push_back(number_from(name, part, range));
    return true;
  };
  return app.add_option(name, read, help)
      ->type_name(shown_range(letter, range) + ",...")
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

/// `--name one,two`, or `--name one --name two`.
CLI::Option* add_names(CLI::App& app, const std::string& name, std::vector<std::string>& values,
                       const std::string& help);

}  // namespace tamis::cli
