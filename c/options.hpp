// Options as C gives them.
#pragma once
#include <functional>

#include "tamis/options.hpp"
#include "tamis/pair.hpp"
#include "tamis/tamis.h"

namespace tamis::c {

/// By its name; NULL: the best. Throws InvalidOptions.
Isa isa_of(const char* name);
/// `vertex_count`: of the mesh, for the arrays that have one entry a vertex. Throws InvalidOptions.
Options options_of(const tamis_options& given, Index vertex_count);
PairOptions options_of(const tamis_pair_options& given);
Options options_of(const tamis_world_options& given);
/// `ask`: as tamis_options::is_cancelled; none where it is NULL.
std::function<bool()> cancelling(int (*ask)(void* user), void* user);

}  // namespace tamis::c
