// Answers for lists of pairs.
#pragma once
#include <algorithm>
#include <vector>

#include "c/sized.hpp"
#include "tamis/pair.hpp"

namespace tamis::c {

inline tamis_pair_result result_of(const PairResult& r) {
  tamis_pair_result result{
      r.touches ? 1 : 0, static_cast<int32_t>(r.certainty), r.toi_lower, r.toi_upper, r.u, r.v, {}};
  std::copy(r.normal.begin(), r.normal.end(), result.normal);
  return result;
}

inline void write_results(const std::vector<PairResult>& answers, tamis_pair_result* results, std::size_t result_size) {
  if (answers.empty()) return;
  required(results, "results");
  check_size(result_size, sizeof(int32_t), "result");
  for (std::size_t i = 0; i < answers.size(); ++i) write_element(result_of(answers[i]), results, i, result_size);
}

}  // namespace tamis::c
