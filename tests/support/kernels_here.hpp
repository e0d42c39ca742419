// The kernels of an instruction set, for tests that compare several.
#pragma once
#include "kernels/kernels.hpp"
#include "tamis/error.hpp"

namespace tamis::test {

/// Null where this machine has no such instructions.
inline const Kernels* kernels_here(Isa isa) {
  try {
    return &kernels(isa);
  } catch (const InvalidOptions&) {
    return nullptr;
  }
}

}  // namespace tamis::test
