// Converts options from C.
#pragma once
#include <functional>

#include "tamis/options.hpp"
#include "tamis/pair.hpp"
#include "tamis/tamis.h"

namespace tamis::c {

/// The instruction set with this name; NULL: Isa::best. Throws InvalidOptions.
Isa isa_of(const char* name);
/// `vertex_count`: that of the mesh, the length of arrays that have one entry a vertex. Throws InvalidOptions.
Options options_of(const tamis_options& given, Index vertex_count);
PairOptions options_of(const tamis_pair_options& given);
Options options_of(const tamis_world_options& given);
/// The function of is_cancelled for C++; none if `ask` is NULL.
std::function<bool()> cancelling(int (*ask)(void* user), void* user);

}  // namespace tamis::c
