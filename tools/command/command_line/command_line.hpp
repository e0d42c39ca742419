// The words of the command line, before and after they are taken apart.
#pragma once
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace tamis::cli {

/// The words in the reversed order that CLI::App::parse takes. A path such as [a,b], which
/// CLI11 would take for a list, becomes ./[a,b].
std::vector<std::string> words_for_parser(const std::vector<std::string>& words);

/// Refuses errors that CLI11 lets pass, or reports in words that do not help. Throws InvalidOptions if the verb has no
/// such option, one is given twice, a value is empty (`--out ""`, `--scale=`, `""` for a file: a variable of the shell
/// that is not set), or an option stands where the value of the one before should (`--out --json`).
void require_sound(const CLI::App& verb, const std::vector<std::string>& reversed_words);

}  // namespace tamis::cli
