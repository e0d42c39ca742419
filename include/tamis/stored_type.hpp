// The number type of a caller's positions.
#pragma once
#include <cstdint>
#include <string_view>

namespace tamis {

/// The number type of the positions that the caller keeps between steps.
enum class StoredType : std::uint8_t { float64, float32 };

/// Returns "float64" or "float32".
[[nodiscard]] std::string_view name_of(StoredType);

}  // namespace tamis
