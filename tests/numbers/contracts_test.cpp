// A broken contract ends the program and says which: a check that is compiled away, or says the opposite, would show.
#include "support/contracts.hpp"

#include <limits>

#include "numbers/dyadic_cell.hpp"
#include "numbers/integer_polynomial.hpp"
#include "numbers/interval.hpp"
#include "pair/exact/exact_distance.hpp"
#include "pair/exact/nearest_point.hpp"
#include "pair/exact/root_isolation.hpp"
#include "pair/motion/pair_kinds.hpp"
#include "pair/narrow/decide.hpp"
#include "pair/narrow/decisions.hpp"
#include "pair/narrow/first_within.hpp"
#include "pair/narrow/kept_distance.hpp"
#include "search/topology/countable.hpp"

namespace tamis::test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// A point that passes through the middle of a face.
constexpr PairPoints kPassing{{{{0, 0, 3}, {-1, -1, 0}, {2, -1, 0}, {-1, 2, 0}}},
                              {{{0, 0, -3}, {-1, -1, 0}, {2, -1, 0}, {-1, 2, 0}}}};
constexpr PairKind kFace = PairKind::vertex_face, kNone = static_cast<PairKind>(kPairKinds);

TEST_F(Contracts, PlaceAndConditionAreSaid) { EXPECT_DEATH(TAMIS_ASSERT(1 > 2), "contracts_test.cpp:[0-9]+: .*1 > 2"); }

TEST_F(Contracts, NoDivisionByZero) {
  EXPECT_DEATH(quotient(Integer(1), Integer(0)), "b.is_zero");
  EXPECT_DEATH((void)(Interval(1) / Interval(-1, 1)), "may_be_zero");
}

TEST_F(Contracts, IntervalsInOrder) {
  EXPECT_DEATH(Interval(1, 0), "low > high");
  EXPECT_NO_FATAL_FAILURE(Interval(kNan, 0));
}

TEST_F(Contracts, DoubleDoublesThatOverlap) { EXPECT_DEATH(DoubleDouble(1, 0.5), "high \\+ low"); }

TEST_F(Contracts, IndexBeyondTheDegree) {
  const IntegerPolynomial p;
  EXPECT_DEATH((void)p[IntegerPolynomial::kMaxDegree + 1], "kMaxDegree");
  EXPECT_DEATH((void)p[-1], "0 <= i");
}

TEST_F(Contracts, RootsOfZero) { EXPECT_DEATH(roots_in_unit_interval(IntegerPolynomial()), "is_zero"); }

TEST_F(Contracts, DoublesInOrder) {
  EXPECT_DEATH(middle_double(1, 0.5), "a <= b");
  EXPECT_DEATH(cell_above(-1), "0 <= lower");
  EXPECT_DEATH((void)lower_end({3, 1}), "cell.n");
}

TEST_F(Contracts, FractionsAndWideDoubles) {
  EXPECT_DEATH((void)wide(Fraction<Integer>{1, 0}), "below.sign");
  EXPECT_DEATH((void)(WideDouble{-1, 0}.root()), "0 <= mantissa");
}

TEST_F(Contracts, ScaledToWhatIsNoInteger) { EXPECT_DEATH(scaled_to_integer(0.5, 0), "lowest_exponent"); }

TEST_F(Contracts, KindsThatThereAreNot) {
  EXPECT_DEATH(with_kind(kNone, [](auto) {}), "is_kind");
  EXPECT_DEATH(make_motion(kNone, kPassing), "is_kind");
}

TEST_F(Contracts, NumbersBeyondAnIndex) { EXPECT_DEATH(number_of(std::size_t{1} << 31), "before <="); }

TEST_F(Contracts, PointsThatAreNotFinite) {
  PairPoints points = kPassing;
  points.end[2][1] = kNan;
  PrecisionCount count;
  EXPECT_DEATH(decide(PairInStep(kFace, points), count), "is_finite");
  EXPECT_DEATH(exact_distance(kFace, points), "is_finite");
}

TEST_F(Contracts, MotionRestrictedTwice) {
  const auto half = restrict_to(make_motion(kFace, kPassing), 0.25, 0.5);
  EXPECT_DEATH(restrict_to(half, 0.0, 0.5), "may_be_whole");
  EXPECT_DEATH(first_within(kFace, half, {0, 1}), "is_whole");
}

TEST_F(Contracts, PartsOfTheStepInOrder) {
  const auto m = make_motion(kFace, kPassing, 0.1);
  EXPECT_DEATH(first_within(kFace, m, {0.75, 0.25}), "is_part_of_step");
  EXPECT_DEATH(decide_in_doubles(kFace, make_motion(kFace, kPassing), {0, 1.5}), "is_part_of_step");
}

TEST_F(Contracts, AllOfTheDistanceKept) {
  PrecisionCount count;
  EXPECT_DEATH(keeps_distance_until(kFace, kPassing, {1, 0}, 1, count), "rule.fraction < 1");
}

}  // namespace
}  // namespace tamis::test
