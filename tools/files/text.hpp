// Lines and tokens of a text held in memory, and exact numbers out of them.
#pragma once
#include <algorithm>
#include <charconv>
#include <cstddef>
#include <optional>
#include <string_view>

namespace tamis::io {

/// Takes what comes before the next `separator` off the front of `rest`, and the separator; all if there is none.
inline std::string_view take_until(std::string_view& rest, char separator) {
  const std::size_t end = rest.find(separator);
  const std::string_view taken = rest.substr(0, end);
  rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
  return taken;
}

/// Walks over lines, counting from 1. A line ends in LF, CR LF or CR alone: if a CR did not end its line, a comment
/// would take the statement behind it along.
class Lines {
 public:
  explicit Lines(std::string_view text, std::size_t lines_before = 0) : rest_(text), number_(lines_before) {}

  /// Steps to the next line; false at the end of the text.
  bool next() {
    if (rest_.empty()) return false;
    const auto* const end = std::find_if(rest_.begin(), rest_.end(), [](char c) { return c == '\n' || c == '\r'; });
    line_ = rest_.substr(0, static_cast<std::size_t>(end - rest_.begin()));
    rest_.remove_prefix(line_.size());
    rest_.remove_prefix(rest_.starts_with("\r\n") ? 2 : std::min<std::size_t>(rest_.size(), 1));
    ++number_;
    return true;
  }
  std::string_view line() const { return line_; }
  std::size_t number() const { return number_; }
  std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_;
  std::string_view line_;
  std::size_t number_;
};

inline bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

/// Takes the next word off the front of `rest`; empty if there is none.
inline std::string_view take_word(std::string_view& rest) {
  std::size_t begin = 0;
  while (begin < rest.size() && is_blank(rest[begin])) ++begin;
  std::size_t end = begin;
  while (end < rest.size() && !is_blank(rest[end])) ++end;
  const std::string_view word = rest.substr(begin, end - begin);
  rest.remove_prefix(end);
  return word;
}

/// A decimal integer, whole word; none if it is something else or does not fit.
template <class Integer>
std::optional<Integer> to_integer(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  Integer value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

/// The double nearest to a decimal number, whole word; none if it is not a number. Words such as "nan", and numbers
/// beyond the largest double, give a value that is not finite.
std::optional<double> to_double(std::string_view word);

}  // namespace tamis::io
