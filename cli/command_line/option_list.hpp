// What a verb takes: its options and the names that follow it. CLI11 takes the command line apart; its headers take
// longer to compile than the verbs do, so that they are included where it is asked, and not here.
#pragma once
#include <string>
#include <vector>

#include "cli/command_line/number_range.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace tamis::cli {

/// One that a list has taken.
class Option {
 public:
  Option() = default;
  explicit Option(CLI::Option* option) : option_(option) {}

  Option required();
  /// What the help calls its value, as in "FILE".
  Option shown_as(const std::string& value);
  /// Once the command line has been read.
  bool is_given() const;

 private:
  CLI::Option* option_ = nullptr;
};

/// Each is read into a variable, which must live as long as the list. Every value is looked at while the command line
/// is read, before any file is.
class OptionList {
 public:
  explicit OptionList(CLI::App& app) : app_(app) {}

  /// `--name`.
  Option add_flag(const std::string& name, bool& value, const std::string& help);
  /// `--name text`; or what stands in that place, if the name is in capitals.
  Option add_text(const std::string& name, std::string& value, const std::string& help);
  /// `--name one --name two`; or all words from that place.
  Option add_texts(const std::string& name, std::vector<std::string>& values, const std::string& help);
  /// `--name one,two`, or `--name one --name two`.
  Option add_names(const std::string& name, std::vector<std::string>& values, const std::string& help);
  /// `--name 3`. T as in number_from().
  template <class T>
  Option add_number(const std::string& name, const std::string& letter, T& value, const NumberRange<T>& range,
                    const std::string& help);
  /// `--name 1,2,3`, or `--name 1 --name 2`.
  template <class T>
  Option add_numbers(const std::string& name, const std::string& letter, std::vector<T>& values,
                     const NumberRange<T>& range, const std::string& help);

 private:
  CLI::App& app_;
};

}  // namespace tamis::cli
