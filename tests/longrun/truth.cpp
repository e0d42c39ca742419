#include "longrun/truth.hpp"

#include <stdexcept>
#include <string>

#include "support/pair_cases.hpp"

namespace tamis::test {

Judge judge_from_name(std::string_view name) {
  if (name == "oracle") return Judge::oracle;
  if (name == "exact") return Judge::exact;
  throw std::invalid_argument("no judge is called '" + std::string(name) + "': use oracle or exact");
}

Truth::Truth(Judge judge, PairKind kind, const oracle::Motion& motion)
    : judge_(judge),
      kind_(kind),
      motion_(motion),
      exact_(judge == Judge::exact ? decide_exactly(kind, to_points(motion)) : Decision{}),
      touches_(judge == Judge::exact ? exact_.touches() : oracle::touches(kind, motion)) {}

bool Truth::touches_before(double time) const {
  if (!touches_ || time <= 0) return false;
  return judge_ == Judge::exact ? exact_.upper < time : oracle::touches(kind_, motion_, {0, time, true});
}

bool Truth::touches_within(double from, double to) const {
  if (!touches_) return false;
  if (judge_ == Judge::exact) return exact_.lower <= to && !touches_before(from);
  return oracle::touches(kind_, motion_, {from, to});
}

}  // namespace tamis::test
