#include "command/command_line/option_list.hpp"

#include <CLI/CLI.hpp>
#include <cstdint>

#include "files/system.hpp"
#include "tamis/error.hpp"

namespace tamis::cli {
namespace {

/// The parts between commas, empty ones too.
std::vector<std::string> split_list(const std::string& text) {
  std::vector<std::string> parts{""};
  for (const char c : text)
    if (c == ',')
      parts.emplace_back();
    else
      parts.back() += c;
  return parts;
}

std::string name_from(const std::string& option, const std::string& text) {
  if (text.empty()) throw InvalidOptions(option + ": a name in the list is empty: correct it");
  return text;
}

/// An option whose words are given to `read`. If that throws InvalidOptions, it is an error of the command line.
template <class Read>
CLI::Option* add_read(CLI::App& app, const std::string& name, const Read& read, const std::string& help) {
  const auto callback = [read](const CLI::results_t& texts) {
    try {
      read(texts);
    } catch (const InvalidOptions& error) {
      throw CLI::ValidationError(error.what());
    }
    return true;
  };
  return app.add_option(name, callback, help);
}

/// An option whose words hold lists; `value_of` makes a value of one part of a list.
template <class T, class ValueOf>
CLI::Option* add_list(CLI::App& app, const std::string& name, std::vector<T>& values, const ValueOf& value_of,
                      const std::string& help) {
  const auto read = [&values, value_of](const CLI::results_t& texts) {
    values.clear();
    for (const std::string& text : texts)
      for (const std::string& part : split_list(text)) values.push_back(value_of(part));
  };
  return add_read(app, name, read, help)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

}  // namespace

Option Option::required() { return Option(option_->required()); }

Option Option::shown_as(const std::string& value) { return Option(option_->type_name(value)); }

bool Option::is_given() const { return option_ != nullptr && option_->count() > 0; }

Option OptionList::add_flag(const std::string& name, bool& value, const std::string& help) {
  return Option(app_.add_flag(name, value, help));
}

Option OptionList::add_text(const std::string& name, std::string& value, const std::string& help) {
  return Option(app_.add_option(name, value, help));
}

Option OptionList::add_path(const std::string& name, std::filesystem::path& value, const std::string& help) {
  const auto read = [&value](const CLI::results_t& texts) { value = system::path_of(texts.back()); };
  return Option(add_read(app_, name, read, help)->type_name("TEXT"));
}

Option OptionList::add_texts(const std::string& name, std::vector<std::string>& values, const std::string& help) {
  return Option(app_.add_option(name, values, help));
}

Option OptionList::add_names(const std::string& name, std::vector<std::string>& values, const std::string& help) {
  const auto value_of = [name](const std::string& text) { return name_from(name, text); };
  return Option(add_list(app_, name, values, value_of, help)->type_name("NAME,..."));
}

template <class T>
Option OptionList::add_number(const std::string& name, const std::string& letter, T& value, const NumberRange<T>& range,
                              const std::string& help) {
  const auto read = [&value, name, range](const CLI::results_t& texts) {
    value = number_from(name, texts.back(), range);
  };
  return Option(add_read(app_, name, read, help)->type_name(shown_range(letter, range)));
}

template <class T>
Option OptionList::add_numbers(const std::string& name, const std::string& letter, std::vector<T>& values,
                               const NumberRange<T>& range, const std::string& help) {
  const auto value_of = [name, range](const std::string& text) { return number_from(name, text, range); };
  return Option(add_list(app_, name, values, value_of, help)->type_name(shown_range(letter, range) + ",..."));
}

using Text = const std::string&;
template Option OptionList::add_number(Text, Text, int&, const NumberRange<int>&, Text);
template Option OptionList::add_number(Text, Text, double&, const NumberRange<double>&, Text);
template Option OptionList::add_number(Text, Text, std::uint64_t&, const NumberRange<std::uint64_t>&, Text);
template Option OptionList::add_numbers(Text, Text, std::vector<int>&, const NumberRange<int>&, Text);
template Option OptionList::add_numbers(Text, Text, std::vector<double>&, const NumberRange<double>&, Text);

}  // namespace tamis::cli
