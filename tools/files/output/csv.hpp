// Cells of tables.
#pragma once
#include <string>
#include <string_view>

namespace tamis::io {

/// A text as one cell: in quotes if it has a comma, a quote or a line end (RFC 4180).
inline std::string csv_cell(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string cell = "\"";
  for (const char c : text) cell += c == '"' ? std::string("\"\"") : std::string(1, c);
  return cell + '"';
}

}  // namespace tamis::io
