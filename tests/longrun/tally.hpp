// What a long run has seen, and the first of its failures in full.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "longrun/truth.hpp"
#include "tamis/pair.hpp"

namespace tamis::test {

struct Tally {
  std::int64_t pairs = 0, touching = 0, failures = 0;

  /// Judges one answer; `checks_times`: its bracket too. Failures are printed, up to ten.
  void add(PairKind kind, const oracle::Motion& motion, const PairResult& answer, const Truth& truth,
           bool checks_times);
  std::string line() const;

 private:
  void require(bool promise, const char* what, PairKind kind, const oracle::Motion& motion);
};

}  // namespace tamis::test
