// The judges of a long run.
#pragma once
#include <string_view>

#include "oracle/oracle.hpp"
#include "pair/exact/exact.hpp"

namespace tamis::test {

enum class Judge { oracle, exact };

/// Throws std::invalid_argument if there is no such judge.
Judge judge_from_name(std::string_view name);

/// What the judge knows of a pair. The oracle answers yes or no at given times, the exact decision gives the first
/// time.
class Truth {
 public:
  Truth(Judge judge, PairKind kind, const oracle::Motion& motion);

  bool touches() const { return touches_; }
  bool touches_before(double time) const;
  bool touches_within(double from, double to) const;

 private:
  Judge judge_;
  PairKind kind_;
  const oracle::Motion& motion_;
  Decision exact_;
  bool touches_;
};

}  // namespace tamis::test
