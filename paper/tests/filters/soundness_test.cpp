// One test for every filter of filters.hpp: whatever it culls, the oracle finds free. All families of motions, all
// placements, vertices in any order, the whole step and parts of it. Catches a wrong formula, a constant too small, a
// sign that holds but for rounding, an overflow taken for a proof.
// TAMIS_FILTER_CASES sets the number of cases a family and placement (long runs).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "paper/filters/filters.hpp"
#include "support/pair_cases.hpp"
#include "support/test_data.hpp"

namespace tamis::test {
namespace {

using lab::FilterList, lab::Filters;
using oracle::Motion, oracle::Times;

template <class... F>
testing::Types<F...> types_of(FilterList<F...>);
using AllFilters = decltype(types_of(Filters{}));

struct FilterName {
  template <class F>
  static std::string GetName(int) {
    return std::string(F::name);
  }
};

template <class Filter>
class FilterSoundness : public testing::Test {
 protected:
  static bool culls(PairKind kind, const PairMotion<double>& m) {
    return kind == PairKind::vertex_face ? Filter::template proves_free<PairKind::vertex_face>(m)
                                         : Filter::template proves_free<PairKind::edge_edge>(m);
  }

  /// A part of the step: half of the time between eighths, where the exact contacts of the families happen.
  static Times random_part(Random& random) {
    double from = random.unit(), to = random.unit();
    if (random.coin()) from = 0.125 * random.below(9), to = 0.125 * random.below(9);
    return {std::min(from, to), std::max(from, to)};
  }

  /// Number of parts, of the whole step and one other, that the filter culls; each must be free.
  static int check(PairKind kind, const Motion& motion, Random& random) {
    const auto whole = make_motion(kind, to_points(motion));
    int culled = 0;
    for (const Times& part : {Times{}, random_part(random)}) {
      const bool is_whole = part.from == 0 && part.to == 1;
      if (!culls(kind, is_whole ? whole : restrict_to(whole, part.from, part.to))) continue;
      ++culled;
      EXPECT_FALSE(oracle::touches(kind, motion, part))
          << "culled, but touches in [" << part.from << ", " << part.to << "]: " << describe(kind, motion);
    }
    return culled;
  }
};

TYPED_TEST_SUITE(FilterSoundness, AllFilters, FilterName);

TYPED_TEST(FilterSoundness, CulledPairsAreFree) {
  const long cases = repetitions("TAMIS_FILTER_CASES", 60);
  Random random(23);
  long culled = 0;
  for (const Family& family : kFamilies)
    for (const Placement& placement : kPlacements)
      for (long i = 0; i < cases && !this->HasFailure(); ++i)
        for (const PairKind kind : {PairKind::vertex_face, PairKind::edge_edge})
          culled += this->check(kind, permuted(kind, placed(family.make(kind, random), placement), random), random);
  this->RecordProperty("culled", static_cast<int>(culled));
  EXPECT_GT(culled, cases);  // the checks above did happen
}

// A sound filter that never culls would pass the test above.
TYPED_TEST(FilterSoundness, CullsADecentShareOfSeparatedPairs) {
  Random random(29);
  constexpr int kCases = 2000;
  for (const PairKind kind : {PairKind::vertex_face, PairKind::edge_edge})
    for (const Placement& placement : kPlacements) {
      if (placement.name == std::string_view("smallest")) continue;  // differences are denormal: nothing is proven
      int culled = 0;
      for (int i = 0; i < kCases; ++i)
        culled += this->culls(
            kind, make_motion(kind, to_points(placed(family_named("separated").make(kind, random), placement))));
      EXPECT_GT(culled, kCases / 5) << placement.name << " of " << kCases;
    }
}

// Finite coordinates whose differences are infinite, as lanes have them: nothing computed from them may prove anything.
TYPED_TEST(FilterSoundness, NothingIsProvenOfOverflow) {
  Random random(31);
  int overflowed = 0;
  for (const PairKind kind : {PairKind::vertex_face, PairKind::edge_edge})
    for (int i = 0; i < 500; ++i) {
      Motion m = family_named("random").make(kind, random);
      for (std::size_t k = 0; k < 4; ++k) m.end[k] = family_named("random").make(kind, random).start[k];
      auto motion = make_motion(kind, to_points(m));
      for (auto* v : {&motion.e, &motion.f, &motion.d})
        for (auto* at : {&v->at0, &v->at1}) *at = 0x1.8p1023 * (4.0 * *at);
      for (double* size : {&motion.size_e, &motion.size_f, &motion.size_d}) *size = 0x1.8p1023 * (4 * *size);
      if (std::isfinite(motion.size_e + motion.size_f + motion.size_d)) continue;
      ++overflowed;
      EXPECT_FALSE(this->culls(kind, motion)) << describe(kind, m);
      EXPECT_FALSE(this->culls(kind, restrict_to(motion, 0.0, 0.5))) << describe(kind, m);
    }
  EXPECT_GT(overflowed, 100);
}

}  // namespace
}  // namespace tamis::test
