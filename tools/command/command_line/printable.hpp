// Makes bytes that others chose, such as names of files, safe for people and programs to read.
#pragma once
#include <string>
#include <string_view>

namespace tamis::cli {

/// Valid UTF-8: every byte that is none becomes \xHH, so that names that differ stay different. For JSON.
std::string utf8_text(std::string_view bytes);

/// utf8_text without control characters (C0, DEL, C1), which a terminal obeys: they become \xHH too.
std::string printable(std::string_view bytes);

}  // namespace tamis::cli
