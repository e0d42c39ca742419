// The option --seed of the verbs that make scenes.
#pragma once
#include <CLI/CLI.hpp>
#include <cstdint>
#include <limits>
#include <string>

namespace tamis::cli {

/// `of` says what the seed is of. A negative number would wrap around to another seed: it is refused.
inline void declare_seed(CLI::App& app, std::uint64_t& seed, const std::string& of) {
  constexpr std::int64_t kLargest = std::numeric_limits<std::int64_t>::max();
  app.add_option("--seed", seed, "of " + of + ": a whole number >= 0; default 1")
      ->type_name("S")
      ->check(CLI::Range(std::int64_t{0}, kLargest).description(""));
}

}  // namespace tamis::cli
