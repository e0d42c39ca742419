// The handle of single pairs and lists of them, which keeps their options, and the common part of all calls with it.
#pragma once
#include <algorithm>
#include <optional>
#include <vector>

#include "c/asked.hpp"
#include "c/handle.hpp"
#include "c/sized.hpp"
#include "c/step.hpp"
#include "tamis/pair.hpp"

struct tamis_pairs : tamis::c::Handle<std::optional<tamis::PairOptions>> {};

namespace tamis::c {

/// The options of a call with a step, whose separation is used in place of the handle's.
inline PairOptions options_for(const tamis_step& given, PairOptions options) {
  require_report(given.at_start);
  if (given.min_separation) options.min_separation = *given.min_separation;
  return options;
}

inline FeaturePair pair_of(const tamis_feature_pair& given) {
  FeaturePair pair;
  // A number that is not a kind must not become one when it is cut to a byte.
  pair.kind = static_cast<PairKind>(given.kind >= 0 && given.kind < 255 ? given.kind : 255);
  std::copy_n(given.vertices, 4, pair.vertices.begin());
  return pair;
}

inline std::vector<FeaturePair> list_of(const tamis_feature_pair* list, std::size_t count) {
  check_count(count, "count");
  std::vector<FeaturePair> pairs(count);
  if (count > 0) std::transform(&required(list, "list"), list + count, pairs.begin(), pair_of);
  return pairs;
}

}  // namespace tamis::c
