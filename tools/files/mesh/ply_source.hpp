// The values of a PLY body: one class reads ascii, one binary. Both have these functions:
//   begin_row(element, row)   the values of this row follow
//   number(type)              the next value; every type of PLY fits into a double exactly
//   end_row()                 throws if the row holds more
//   place()                   where the row is, as text
//   end()                     throws if the file holds more than its header says
// They throw FileError, naming the row.
#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <string>
#include <string_view>

#include "files/error.hpp"
#include "files/mesh/ply_header.hpp"
#include "files/text.hpp"

namespace tamis::io {

inline constexpr const char* kCutShort = "the file ends here: it was cut short, write or copy it again";
inline constexpr const char* kTooLong =
    "the file holds more than its header announces: correct the counts in the header or write the file again";

/// The row being read, for messages.
struct PlyRow {
  std::string_view element;
  std::uint64_t index = 0;
  std::string text() const { return fmt::format("{} {}", in_quotes(element), index); }
};

class AsciiSource {
 public:
  AsciiSource(std::string_view body, const PlyHeader& header, const std::string& name)
      : lines_(body, header.lines), name_(name) {}

  /// The smallest size of a row: a digit and a separator for each value. `bytes_left` adds the separator that the
  /// file's last value may lack.
  static std::uint64_t least_bytes(const PlyElement& element) { return 2 * element.properties.size(); }
  std::uint64_t bytes_left() const { return lines_.rest().size() + 1; }

  /// A row stands on a line of its own; blank lines are skipped.
  void begin_row(std::string_view element, std::uint64_t row) {
    row_ = {element, row};
    if (!next_line()) fail(kCutShort);
  }
  double number(PlyScalar) {
    const std::string_view word = take_word(rest_);
    if (word.empty()) fail("the line ends too early: give every value that the header announces");
    const auto value = to_double(word);
    if (!value) fail(fmt::format("{} is not a number: correct the file", in_quotes(word)));
    return *value;
  }
  void end_row() {
    if (!take_word(rest_).empty()) fail("the line holds more values than announced: correct the line or the header");
  }
  void end() {
    if (next_line()) throw FileError(name_, fmt::format("line {}", lines_.number()), kTooLong);
  }

  std::string place() const { return fmt::format("line {}, {}", lines_.number(), row_.text()); }
  [[noreturn]] void fail(const std::string& what) const { throw FileError(name_, place(), what); }

 private:
  bool next_line() {
    while (lines_.next()) {
      rest_ = lines_.line();
      if (!std::all_of(rest_.begin(), rest_.end(), is_blank)) return true;
    }
    return false;
  }

  Lines lines_;
  std::string_view rest_;
  const std::string& name_;
  PlyRow row_;
};

template <std::endian order>
class BinarySource {
 public:
  BinarySource(std::string_view body, const PlyHeader&, const std::string& name) : left_(body), name_(name) {}

  static std::uint64_t least_bytes(const PlyElement& element) {
    std::uint64_t bytes = 0;
    for (const PlyProperty& p : element.properties) bytes += size_of(p.is_list ? p.count_type : p.type);
    return bytes;
  }
  std::uint64_t bytes_left() const { return left_.size(); }

  void begin_row(std::string_view element, std::uint64_t row) { row_ = {element, row}; }
  double number(PlyScalar type) {
    switch (type) {
      case PlyScalar::int8:
        return take<std::int8_t>();
      case PlyScalar::uint8:
        return take<std::uint8_t>();
      case PlyScalar::int16:
        return take<std::int16_t>();
      case PlyScalar::uint16:
        return take<std::uint16_t>();
      case PlyScalar::int32:
        return take<std::int32_t>();
      case PlyScalar::uint32:
        return take<std::uint32_t>();
      case PlyScalar::float32:
        return static_cast<double>(take<float>());
      case PlyScalar::float64:
        return take<double>();
    }
    fail("unknown type");
  }
  void end_row() {}
  /// Line ends after the body do no harm.
  void end() const {
    if (left_.find_first_not_of("\r\n") != std::string_view::npos)
      throw FileError(name_, "after the last row", kTooLong);
  }

  std::string place() const { return row_.text(); }
  [[noreturn]] void fail(const std::string& what) const { throw FileError(name_, place(), what); }

 private:
  template <class T>
  T take() {
    if (left_.size() < sizeof(T)) fail(kCutShort);
    std::array<char, sizeof(T)> bytes;
    std::memcpy(bytes.data(), left_.data(), sizeof(T));
    if constexpr (order != std::endian::native) std::reverse(bytes.begin(), bytes.end());
    left_.remove_prefix(sizeof(T));
    return std::bit_cast<T>(bytes);
  }

  std::string_view left_;
  const std::string& name_;
  PlyRow row_;
};

}  // namespace tamis::io
