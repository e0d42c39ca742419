// The ratio that float lanes use in place of a division, over every mantissa; and lanes as bits and columns.
#include "numbers/lanes.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

namespace tamis::TAMIS_ISA {
namespace {

/// Largest relative error of 1/b over all mantissas at one exponent and sign.
double worst_error(std::uint32_t high_bits) {
  double worst = 0;
  float b[kFloatLanes], quotient[kFloatLanes];
  for (std::uint32_t mantissa = 0; mantissa < (1u << 23); mantissa += kFloatLanes) {
    for (int i = 0; i < kFloatLanes; ++i)
      b[i] = std::bit_cast<float>(high_bits | (mantissa + static_cast<std::uint32_t>(i)));
    Ratio<FloatLanes>::of(FloatLanes(1.0f), FloatLanes::load_unaligned(b)).store_unaligned(quotient);
    for (int i = 0; i < kFloatLanes; ++i) worst = std::max(worst, std::fabs(double(quotient[i]) * double(b[i]) - 1));
  }
  return worst;
}

TEST(Ratio, StaysWithinItsStatedErrorForEveryMantissa) {
  // Would catch a wrong first guess, a lost step of Newton, or an error stated too small: any of them a missed contact.
  constexpr std::uint32_t kNegative = 0x80000000u;
  for (std::uint32_t exponent : {27u, 100u, 126u, 127u, 128u, 200u, 226u})
    for (std::uint32_t sign : {0u, kNegative}) {
      EXPECT_LE(worst_error(sign | (exponent << 23)), Ratio<FloatLanes>::kError) << exponent;
    }
  EXPECT_GE(worst_error(127u << 23), Ratio<FloatLanes>::kError / 2);  // the bound is no fiction
}

TEST(Lanes, ColumnsOfScatteredRows) {
  // Would catch quarters of a register in the wrong order: pairs would get other pairs' vertices.
  float rows[32][8];
  for (int i = 0; i < 32; ++i)
    for (int j = 0; j < 8; ++j) rows[i][j] = static_cast<float>(10 * i + j);
  std::int32_t index[kFloatLanes];
  for (int i = 0; i < kFloatLanes; ++i) index[i] = (7 * i + 3) % 32;
  FloatLanes columns[7];
  load_columns(rows, index, columns);
  for (int j = 0; j < 7; ++j) {
    float lanes[kFloatLanes];
    columns[j].store_unaligned(lanes);
    for (int i = 0; i < kFloatLanes; ++i) EXPECT_EQ(lanes[i], rows[index[i]][j]) << i << ' ' << j;
  }
}

TEST(Lanes, TheLeastIsFoundInEveryLane) {
  // Would catch a lane left out: a hull too small, and pairs never looked at.
  for (int least_lane = 0; least_lane < kFloatLanes; ++least_lane) {
    float lanes[kFloatLanes];
    for (int i = 0; i < kFloatLanes; ++i) lanes[i] = i == least_lane ? -3.0f : static_cast<float>(i);
    EXPECT_EQ(least(FloatLanes::load_unaligned(lanes)), -3.0f) << least_lane;
  }
}

TEST(Lanes, OfNaNAndANumberTheNumberIsTaken) {
  // Would catch instructions that make NaN of both, as ARM's do: the slab clip then culled every pair.
  const auto expect = [](auto lanes, const char* name) {
    using Lanes = decltype(lanes);
    using Number = typename Lanes::value_type;
    const Lanes nan(std::numeric_limits<Number>::quiet_NaN()), two(Number(2));
    Number least[Lanes::size], largest[Lanes::size];
    Masked<Lanes>::min_number(nan, two).store_unaligned(least);
    Masked<Lanes>::max_number(nan, two).store_unaligned(largest);
    for (std::size_t i = 0; i < Lanes::size; ++i) {
      EXPECT_EQ(least[i], 2) << name;
      EXPECT_EQ(largest[i], 2) << name;
    }
  };
  expect(FloatLanes(0), "floats");
  expect(DoubleLanes(0), "doubles");
}

TEST(Lanes, BitsNameLanesFromTheLowest) {
  double values[kDoubleLanes];
  for (int j = 0; j < kDoubleLanes; ++j) values[j] = j;
  EXPECT_EQ(bits(DoubleLanes::load_unaligned(values) < DoubleLanes(1.0)), 1u);
}

}  // namespace
}  // namespace tamis::TAMIS_ISA
