// A broken contract ends the program and says which: a check that is compiled away, or says the opposite, would show.
#include <gtest/gtest.h>

#include "exact/dyadic_cell.hpp"
#include "exact/integer_polynomial.hpp"
#include "exact/root_isolation.hpp"
#include "filters/contour_test.hpp"
#include "numerics/assert.hpp"

namespace tamis {
namespace {

class Contracts : public testing::Test {
 protected:
  void SetUp() override {
#ifndef TAMIS_CHECK_CONTRACTS
    GTEST_SKIP() << "built without TAMIS_CHECK_CONTRACTS";
#endif
    GTEST_FLAG_SET(death_test_style, "threadsafe");
  }
};

TEST_F(Contracts, PlaceAndConditionAreSaid) { EXPECT_DEATH(TAMIS_ASSERT(1 > 2), "contracts_test.cpp:[0-9]+: .*1 > 2"); }

TEST_F(Contracts, NoDivisionByZero) { EXPECT_DEATH(quotient(Integer(1), Integer(0)), "b.sign"); }

TEST_F(Contracts, IndexBeyondTheDegree) {
  const IntegerPolynomial p;
  EXPECT_DEATH((void)p[IntegerPolynomial::kMaxDegree + 1], "kMaxDegree");
  EXPECT_DEATH((void)p[-1], "0 <= i");
}

TEST_F(Contracts, RootsOfZero) { EXPECT_DEATH(roots_in_unit_interval(IntegerPolynomial()), "is_zero"); }

TEST_F(Contracts, DoublesInOrder) {
  EXPECT_DEATH(middle_double(1, 0.5), "a <= b");
  EXPECT_DEATH(cell_above(-1), "0 <= lower");
}

TEST_F(Contracts, ContourOfTwoPoints) {
  const Moving<double> points[2] = {};
  ProjectedContour contour;
  EXPECT_DEATH(contour.project(points, {0, 0, 1}), "loop.size");
}

}  // namespace
}  // namespace tamis
