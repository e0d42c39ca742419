// tamis_longrun pair|lanes oracle|exact COUNT [--seed S]: so many pairs of all families and placements, random and
// degenerate, one by one or many in a mesh, against a judge. Brackets are judged too, where the judge gives times for
// nothing, and for one pair in 16 elsewhere. Prints what it has seen ten times on its way. Exit code 1: a promise is
// broken; the pairs are on the standard error output.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "longrun/one_place.hpp"
#include "longrun/tally.hpp"
#include "support/pair_cases.hpp"

namespace tamis::test {
namespace {

constexpr PairKind kKinds[] = {PairKind::vertex_face, PairKind::edge_edge};

struct Run {
  bool in_lanes;
  Judge judge;
  std::int64_t count;
  std::uint64_t seed;
};

std::vector<oracle::Motion> next_motions(PairKind kind, Random& random) {
  const auto& family = kFamilies[static_cast<std::size_t>(random.below(static_cast<Index>(kFamilies.size())))];
  const auto& placement = kPlacements[static_cast<std::size_t>(random.below(static_cast<Index>(kPlacements.size())))];
  std::vector<oracle::Motion> motions;
  for (Index i = 0; i < OnePlace::kPairs; ++i)
    motions.push_back(permuted(kind, placed(family.make(kind, random), placement), random));
  return motions;
}

class LongRun {
 public:
  explicit LongRun(const Run& run) : run_(run), random_(run.seed) {}

  int go() {
    std::int64_t next_report = run_.count / 10;
    for (int turn = 0; tally_.pairs < run_.count; ++turn) {
      next_report = std::min(next_report, run_.count);
      const PairKind kind = kKinds[turn % 2];
      judge(kind, next_motions(kind, random_));
      if (tally_.pairs < next_report) continue;
      report();
      next_report += run_.count / 10 + 1;
    }
    return tally_.failures > 0 ? 1 : 0;
  }

 private:
  void judge(PairKind kind, const std::vector<oracle::Motion>& motions) {
    const auto found = answers(kind, motions);
    for (std::size_t i = 0; i < motions.size(); ++i) {
      const Truth truth(run_.judge, kind, motions[i]);
      const bool checks_times = run_.judge == Judge::exact || random_.below(16) == 0;
      tally_.add(kind, motions[i], found[i], truth, checks_times);
    }
  }

  std::vector<PairResult> answers(PairKind kind, const std::vector<oracle::Motion>& motions) {
    if (run_.in_lanes) return lanes_[kind == kKinds[1]].answers(motions);
    std::vector<PairResult> results;
    for (const oracle::Motion& m : motions)
      results.push_back(kind == PairKind::vertex_face ? vertex_face(m.start, m.end) : edge_edge(m.start, m.end));
    return results;
  }

  void report() const {
    std::printf("%s\n", tally_.line().c_str());
    std::fflush(stdout);
  }

  Run run_;
  Random random_;
  OnePlace lanes_[2] = {OnePlace(kKinds[0]), OnePlace(kKinds[1])};
  Tally tally_;
};

Run run_of(const std::vector<std::string>& arguments) {
  const bool has_seed = arguments.size() == 5 && arguments[3] == "--seed";
  if (arguments.size() != 3 && !has_seed) throw std::invalid_argument("arguments: pair|lanes oracle|exact COUNT");
  if (arguments[0] != "pair" && arguments[0] != "lanes")
    throw std::invalid_argument("no way is called '" + arguments[0] + "': use pair or lanes");
  return {arguments[0] == "lanes", judge_from_name(arguments[1]), std::stoll(arguments[2]),
          has_seed ? std::stoull(arguments[4]) : 1};
}

}  // namespace
}  // namespace tamis::test

int main(int argc, char** argv) {
  try {
    return tamis::test::LongRun(tamis::test::run_of({argv + 1, argv + argc})).go();
  } catch (const std::exception& e) {
    std::fprintf(stderr, "tamis_longrun: %s\n", e.what());
    return 2;
  }
}
