// Two words against the compiler's own integers of 128 bits, where it has them.
#include "numbers/two_words.hpp"

#include <gtest/gtest.h>

#include "scenes/random.hpp"

namespace tamis {
namespace {

#ifdef __SIZEOF_INT128__
__extension__ using Wide = unsigned __int128;
__extension__ using SignedWide = __int128;

Wide wide(TwoWords a) { return Wide{a.high} << 64 | a.low; }
TwoWords two_words(Wide a) { return {static_cast<std::uint64_t>(a), static_cast<std::uint64_t>(a >> 64)}; }

/// Numbers of all sizes and signs; halfway between two doubles or next to it; next to powers of two.
Wide any(scenes::Random& random) {
  const int size = random.below(128);
  const Wide one = 1, near_one = static_cast<Wide>(random.below(5)) - 2;
  Wide result = Wide{random.bits()} << 64 | random.bits();
  if (const int shape = random.below(3); shape == 0)
    result >>= size;
  else if (shape == 1)
    result = (one << size) + (size >= 53 ? one << (size - 53) : 0) + near_one;
  else
    result = (one << size) + near_one;
  return random.coin() ? result : 0 - result;
}

// A carry that is lost, or a double that is rounded twice, gives another answer on some compilers alone.
TEST(TwoWords, AreTheCompilersIntegers) {
  scenes::Random random(71);
  for (int i = 0; i < 200000; ++i) {
    const Wide a = any(random), b = any(random);
    const TwoWords x = two_words(a), y = two_words(b);
    const int bits = 1 + random.below(127);
    ASSERT_TRUE(wide(x + y) == a + b && wide(-x) == 0 - a && wide(x * y) == a * b && wide(x << bits) == a << bits);
    ASSERT_EQ(x.to_double(), static_cast<double>(static_cast<SignedWide>(a))) << x.high << " " << x.low;
  }
}
#endif

TEST(TwoWords, OfSmallNumbers) {
  EXPECT_EQ(TwoWords::of(-3), -TwoWords::of(3));
  EXPECT_EQ(TwoWords::of(-3).to_double(), -3);
  EXPECT_EQ((TwoWords::of(1) << 64).to_double(), 0x1p64);
}

}  // namespace
}  // namespace tamis
