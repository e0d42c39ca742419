// Decides one thread's part of a list of pairs in lanes. Pairs that lanes leave undecided are decided one by one.
#pragma once
#include <span>

#include "search/kernels/kernels.hpp"
#include "tamis/pair.hpp"

namespace tamis {

struct ListPart {
  std::span<const FeaturePair> pairs;  ///< fewer than 2^31
  const Step& step;
  const Kernels& kernels;
  const PairOptions& options;  ///< valid
};

/// Decides pairs[i] into results[i]. Returns false if some pair is not legal: no valid kind, a vertex that is not a row
/// of the step, a coordinate that is not finite. The results then have no meaning. Throws Cancelled. REQUIRES: as many
/// positions at both ends of the step, as many results as pairs.
bool decide_part_of_list(const ListPart& part, std::span<PairResult> results);

}  // namespace tamis
