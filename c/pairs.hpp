// The handle of single pairs and lists of them, and the common part of all calls with it.
#pragma once
#include <algorithm>
#include <vector>

#include "c/sized.hpp"
#include "tamis/pair.hpp"

struct tamis_pairs {
  tamis::c::Outcome outcome;
  tamis::PairOptions options;
  bool is_made = false;
};

namespace tamis::c {

/// Runs `work(handle)`, unless the handle could not be made: then it keeps the message that says why.
template <class Work>
tamis_status ask(tamis_pairs* pairs, const Work& work) noexcept {
  if (!pairs) return TAMIS_INVALID_ARGUMENT;
  if (!pairs->is_made) return pairs->outcome.status();
  return attempt(pairs->outcome, [&] { work(*pairs); });
}

inline Pair pair_of(const tamis_pair& given) {
  Pair pair;
  // A number that is no kind must not become one when it is cut to a byte.
  pair.kind = static_cast<PairKind>(given.kind >= 0 && given.kind < 255 ? given.kind : 255);
  std::copy_n(given.vertices, 4, pair.vertices.begin());
  return pair;
}

inline std::vector<Pair> list_of(const tamis_pair* list, std::size_t count) {
  check_count(count, "count");
  std::vector<Pair> pairs(count);
  if (count > 0) std::transform(&required(list, "list"), list + count, pairs.begin(), pair_of);
  return pairs;
}

}  // namespace tamis::c
