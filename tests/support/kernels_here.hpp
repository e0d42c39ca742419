// Instruction sets and their kernels, for tests that compare several.
#pragma once
#include <vector>

#include "search/kernels/kernels.hpp"
#include "tamis/error.hpp"

namespace tamis::test {

/// All instruction sets with a name, without `best`, which stands for one of them. This machine may lack some.
inline std::vector<Isa> every_isa() {
  std::vector<Isa> all;
  for (int isa = 1; name_of(static_cast<Isa>(isa)) != kUnnamed; ++isa) all.push_back(static_cast<Isa>(isa));
  return all;
}

/// Null if this machine lacks the instruction set.
inline const Kernels* kernels_here(Isa isa) {
  try {
    return &kernels(isa);
  } catch (const InvalidOptions&) {
    return nullptr;
  }
}

}  // namespace tamis::test
