// How well and how fast a set of single queries was answered.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "command/report.hpp"
#include "paper/queries/queries.hpp"
#include "tamis/pair.hpp"

namespace tamis::lab {

struct QueryScore {
  std::uint64_t queries = 0;
  std::uint64_t labelled = 0;  ///< queries whose file gives the answer
  std::uint64_t contacts = 0;
  std::uint64_t false_positives = 0;
  std::uint64_t false_positives_certified = 0;  ///< false positives that were not reported as unresolved
  std::uint64_t false_negatives = 0;
  std::uint64_t unresolved = 0;
  std::vector<double> nanoseconds;  ///< one entry a query

  void add(const SingleQuery& query, const PairResult& result);
  void add(const QueryScore& other);
  /// No contact was missed, and none was claimed to be certain that is not there.
  bool keeps_promise() const { return false_negatives == 0 && false_positives_certified == 0; }
};

struct Percentiles {
  double mean = 0;
  double p50 = 0;
  double p99 = 0;
  double max = 0;
};

Percentiles percentiles_of(std::vector<double> values);

/// Answers every query; each time is the median of `repeat` passes after one that warms up. The answers are appended to
/// `results`.
QueryScore answer(const std::vector<SingleQuery>& queries, const PairOptions& options, int repeat,
                  std::vector<PairResult>& results);

}  // namespace tamis::lab
