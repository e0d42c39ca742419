// Converts an index to a place in a vector.
#pragma once
#include <cstddef>

#include "tamis/mesh.hpp"

namespace tamis {

inline std::size_t at(Index index) { return static_cast<std::size_t>(index); }

}  // namespace tamis
