// The exception that file readers and writers throw.
#pragma once
#include <fmt/format.h>

#include <string>
#include <string_view>

#include "tamis/error.hpp"

namespace tamis::io {

/// A file that cannot be used. The message is one sentence: which file, where in it, what is wrong, what to do.
struct FileError : Error {
  using Error::Error;
  /// `where` is a line or an element; may be empty.
  FileError(std::string_view file, std::string_view where, std::string_view what)
      : Error(fmt::format("{}: {}{}{}", file, where, where.empty() ? "" : ": ", what)) {}
};

/// A word of the file as a message may show it: in quotes, cut after 40 characters, nothing unprintable.
inline std::string in_quotes(std::string_view word) {
  constexpr std::size_t kLongest = 40;
  std::string text(word.substr(0, kLongest));
  for (char& c : text)
    if (c < ' ' || c > '~') c = '?';
  return fmt::format("'{}{}'", text, word.size() > kLongest ? "..." : "");
}

}  // namespace tamis::io
