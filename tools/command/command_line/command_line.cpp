#include "command/command_line/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iterator>
#include <numeric>
#include <set>
#include <string_view>
#include <utility>

#include "files/text.hpp"
#include "tamis/error.hpp"

namespace tamis::cli {
namespace {

/// The option whose number may be missing: it then stands for 0, and the next word is a name.
constexpr std::string_view kWeld = "--weld";

bool is_option(const std::string& word) { return word.size() > 2 && word.starts_with("--"); }

[[noreturn]] void fail_without(const std::string& what) {
  throw InvalidOptions(what + ": give one (is a variable of the shell not set?)");
}

/// How many letters to put in, leave out or change to make one of the other (Levenshtein 1966).
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t changed = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = std::exchange(row[j + 1], std::min({changed, row[j] + 1, row[j + 1] + 1}));
    }
  }
  return row.back();
}

/// " (--scale?)" for --sclae; empty if no option's name comes near.
std::string suggestion(const CLI::App& verb, const std::string& name) {
  std::size_t least = 1 + name.size() / 3;
  std::string nearest;
  for (const CLI::Option* option : verb.get_options())
    for (const std::string& known : option->get_lnames())
      if (const std::size_t distance = edit_distance("--" + known, name); distance < least) {
        least = distance;
        nearest = " (--" + known + "?)";
      }
  return nearest;
}

const CLI::Option& option_named(const CLI::App& verb, const std::string& name) {
  const CLI::Option* option = verb.get_option_no_throw(name);
  if (option == nullptr)
    throw InvalidOptions(fmt::format("{} has no option {}{}: see '{} {} --help'", verb.get_name(), name,
                                     suggestion(verb, name), verb.get_parent()->get_name(), verb.get_name()));
  return *option;
}

}  // namespace

std::vector<std::string> words_for_parser(const std::vector<std::string>& words) {
  std::vector<std::string> reversed;
  for (std::size_t i = words.size(); i-- > 0;) {
    std::string word = words[i];
    const bool has_number = i + 1 < words.size() && io::to_double(words[i + 1]);
    if (word == kWeld && !has_number) word += "=0";
    reversed.push_back(word.size() > 1 && word.front() == '[' && word.back() == ']' ? "./" + word : word);
  }
  return reversed;
}

void require_sound(const CLI::App& verb, const std::vector<std::string>& reversed_words) {
  std::set<const CLI::Option*> given;
  bool has_options = true;  // "--" ends them
  for (auto word = reversed_words.rbegin(); word != reversed_words.rend(); ++word) {
    if (word->empty()) fail_without("an argument is empty");
    has_options = has_options && *word != "--";
    if (!has_options || !is_option(*word)) continue;
    if (word->back() == '=') fail_without(word->substr(0, word->size() - 1) + " has an empty value");
    const std::string name = word->substr(0, word->find('='));
    const CLI::Option& option = option_named(verb, name);
    const bool takes_one =
        option.get_expected_max() <= 1 && option.get_multi_option_policy() == CLI::MultiOptionPolicy::Throw;
    if (!given.insert(&option).second && takes_one)
      throw InvalidOptions(option.get_name() + " is given twice: give it once");
    if (option.get_items_expected_min() == 0 || word->find('=') != std::string::npos) continue;
    const auto value = std::next(word);
    if (value == reversed_words.rend() || is_option(*value)) fail_without(*word + " has no value");
    if (value->empty()) fail_without(*word + " has an empty value");
  }
}

}  // namespace tamis::cli
