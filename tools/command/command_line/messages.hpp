// Messages of the command on stderr. They never throw: a stderr that is closed or full must not cost the answer.
#pragma once
#include <string>
#include <string_view>

namespace tamis::cli {

/// A line `note: ...`: something worth knowing that is no error. Unprintable bytes are shown as \xHH.
void note(std::string_view sentence) noexcept;

/// A line `tamis: ...`: why there is no answer. Returns kError.
int fail(std::string_view sentence) noexcept;

/// Writes the text as it is, for a terminal.
void show(std::string_view text) noexcept;

}  // namespace tamis::cli
