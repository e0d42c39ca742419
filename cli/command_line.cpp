#include "cli/command_line.hpp"

#include <CLI/CLI.hpp>
#include <iterator>

#include "tamis/error.hpp"

namespace tamis::cli {
namespace {

bool is_option(const std::string& word) { return word.size() > 2 && word.starts_with("--"); }

[[noreturn]] void fail_without(const std::string& what) {
  throw InvalidOptions(what + ": give one (is a variable of the shell not set?)");
}

bool takes_value(const CLI::App& verb, const std::string& name) {
  const CLI::Option* option = verb.get_option_no_throw(name);
  return option != nullptr && option->get_items_expected_min() > 0;
}

}  // namespace

std::vector<std::string> words_of(int argc, char** argv) {
  std::vector<std::string> words;
  for (int i = argc - 1; i > 0; --i) {
    const std::string word = argv[i];
    words.push_back(word.size() > 1 && word.front() == '[' && word.back() == ']' ? "./" + word : word);
  }
  return words;
}

void require_values(const CLI::App& verb, const std::vector<std::string>& reversed_words) {
  bool has_options = true;  // "--" ends them
  for (auto word = reversed_words.rbegin(); word != reversed_words.rend(); ++word) {
    if (word->empty()) fail_without("an argument is empty");
    has_options = has_options && *word != "--";
    if (!has_options || !is_option(*word)) continue;
    if (word->back() == '=') fail_without(word->substr(0, word->size() - 1) + " has an empty value");
    if (!takes_value(verb, *word)) continue;
    const auto value = std::next(word);
    if (value == reversed_words.rend() || is_option(*value)) fail_without(*word + " has no value");
    if (value->empty()) fail_without(*word + " has an empty value");
  }
}

}  // namespace tamis::cli
