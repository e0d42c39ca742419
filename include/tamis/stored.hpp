// In which numbers a caller keeps positions.
#pragma once
#include <cstdint>

namespace tamis {

/// The numbers in which the caller keeps positions between steps.
enum class Stored : std::uint8_t { float64, float32 };

}  // namespace tamis
