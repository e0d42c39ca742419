// Rows of a table, written in pieces: there may be millions.
#pragma once
#include <fmt/format.h>

#include <iterator>
#include <string_view>
#include <utility>

#include "files/atomic_file.hpp"

namespace tamis::io {

class CsvTable {
 public:
  /// Throws FileError, as the others do.
  CsvTable(const std::filesystem::path& path, std::string_view header) : file_(path) { row("{}\n", header); }

  /// `text`: a format string of fmt, with the end of the line.
  template <class... Values>
  void row(fmt::format_string<Values...> text, Values&&... values) {
    fmt::format_to(std::back_inserter(rows_), text, std::forward<Values>(values)...);
    if (rows_.size() > kMost) flush();
  }
  /// The whole table stands, or none of it.
  void commit() {
    flush();
    file_.commit();
  }

 private:
  static constexpr std::size_t kMost = std::size_t{1} << 16;

  void flush() {
    file_.append({rows_.data(), rows_.size()});
    rows_.clear();
  }

  AtomicFile file_;
  fmt::memory_buffer rows_;
};

}  // namespace tamis::io
