// Answers for lists of pairs.
#pragma once
#include <algorithm>
#include <string>

#include "c/sized.hpp"
#include "tamis/pair.hpp"

namespace tamis::c {

/// Where the caller wants them.
struct PairResults {
  std::size_t count;
  void* array;
  std::size_t element_size;
};

inline tamis_pair_result result_of(const PairResult& r) {
  tamis_pair_result result{
      r.touches ? 1 : 0, static_cast<int32_t>(r.certainty), r.toi_lower, r.toi_upper, r.u, r.v, {}};
  std::copy(r.normal.begin(), r.normal.end(), result.normal);
  return result;
}

/// Writes `decide(i)` for each pair; a refused one is named.
template <class Decide>
void write_each(const PairResults& results, const Decide& decide) {
  required(static_cast<unsigned char*>(results.array), "results");
  check_size(results.element_size, sizeof(int32_t), "result");
  for (std::size_t i = 0; i < results.count; ++i) try {
      write_element(result_of(decide(i)), results.array, i, results.element_size);
    } catch (const InvalidStep& e) {
      throw InvalidStep("pair " + std::to_string(i) + ": " + e.what());
    }
}

}  // namespace tamis::c
