// Converts kinds of pairs from C.
#pragma once
#include <string>

#include "c/failure.hpp"
#include "tamis/contact.hpp"

namespace tamis::c {

static_assert(TAMIS_VERTEX_VERTEX + 1 == kPairKinds, "name each kind of pair in include/tamis/c/answers.h");

inline PairKind known_kind(int32_t kind) {
  if (kind < TAMIS_VERTEX_FACE || kind > TAMIS_VERTEX_VERTEX)
    throw InvalidArgument("unknown kind number " + std::to_string(kind) + ": give TAMIS_VERTEX_FACE, ...");
  return static_cast<PairKind>(kind);
}

}  // namespace tamis::c
