// What the command says on stderr. A stderr that is closed or full takes nothing away from the answer: these never
// throw.
#pragma once
#include <string>
#include <string_view>

namespace tamis::cli {

/// A line `note: ...`: something worth knowing that is no error. Unprintable bytes are shown as \xHH.
void note(std::string_view sentence) noexcept;

/// A line `tamis: ...`: why there is no answer. Returns kError.
int fail(std::string_view sentence) noexcept;

/// As it is, for a terminal.
void show(std::string_view text) noexcept;

}  // namespace tamis::cli
