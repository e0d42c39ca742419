// The options of a verb and the names that follow the verb. CLI11 takes the command line apart; its headers take longer
// to compile than the verbs, so only the files that call CLI11 include them.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "command/command_line/number_range.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace tamis::cli {

/// An option that was added to an OptionList.
class Option {
 public:
  Option() = default;
  explicit Option(CLI::Option* option) : option_(option) {}

  Option required();
  /// What the help calls its value, as in "FILE".
  Option shown_as(const std::string& value);
  /// Known once the command line has been read.
  bool is_given() const;

 private:
  CLI::Option* option_ = nullptr;
};

/// Each option is read into a variable, which must live as long as the list. Every value is checked while the command
/// line is read, before any file is read.
class OptionList {
 public:
  explicit OptionList(CLI::App& app) : app_(app) {}

  /// `--name`.
  Option add_flag(const std::string& name, bool& value, const std::string& help);
  /// `--name text`; a name in capitals takes the word in that place of the command line.
  Option add_text(const std::string& name, std::string& value, const std::string& help);
  /// As add_text, for the name of a file or folder.
  Option add_path(const std::string& name, std::filesystem::path& value, const std::string& help);
  /// `--name one --name two`; a name in capitals takes all words from that place on.
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
