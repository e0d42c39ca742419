// Integer against residues modulo two primes, which need no integers of any size. Sizes are around the border between
// own limbs and the heap: a move that leaves a pointer into the old place would show here.
#include "numbers/integer.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace tamis {
namespace {

constexpr std::array<std::uint64_t, 2> kPrimes{4294967291, 4294967279};  // products fit in 64 bits

/// Residues modulo both primes. Two different integers share them by chance once in 2^64 times.
struct Residues {
  std::array<std::uint64_t, 2> of{};

  Residues() = default;
  explicit Residues(std::uint64_t x) : of{x % kPrimes[0], x % kPrimes[1]} {}

  template <class Operation>
  static Residues each(const Operation& operation) {
    Residues result;
    for (std::size_t i = 0; i < 2; ++i) result.of[i] = operation(i) % kPrimes[i];
    return result;
  }
  friend Residues operator+(const Residues& a, const Residues& b) {
    return each([&](std::size_t i) { return a.of[i] + b.of[i]; });
  }
  friend Residues operator-(const Residues& a, const Residues& b) {
    return each([&](std::size_t i) { return a.of[i] + kPrimes[i] - b.of[i]; });
  }
  friend Residues operator*(const Residues& a, const Residues& b) {
    return each([&](std::size_t i) { return a.of[i] * b.of[i]; });
  }
  friend bool operator==(const Residues& a, const Residues& b) { return a.of == b.of; }
};

Residues two_to(int power) {
  Residues result(1);
  for (; power > 0; --power) result = result + result;
  return result;
}

Residues residues_of(const Integer& a) {
  const Residues next_word = two_to(64);
  Residues size;
  for (int first = a.bits() / 64 * 64; first >= 0; first -= 64) size = size * next_word + Residues(a.bits_from(first));
  return a.sign() < 0 ? Residues() - size : size;
}

struct Both {
  Integer ours;
  Residues reference;
};

bool agree(const Both& x) { return residues_of(x.ours) == x.reference; }
bool are_equal(const Integer& a, const Integer& b) { return (a - b).sign() == 0; }
Integer size_of(const Integer& a) { return a.sign() < 0 ? -a : a; }

class RandomIntegers {
 public:
  int below(int bound) { return static_cast<int>(engine_() % static_cast<unsigned>(bound)); }
  /// Long runs of zeros and of ones are among the bits: these carry far.
  Both number(int most_bits) {
    Both x;
    for (int rest = below(most_bits + 1); rest > 0;) {
      const int count = std::min(rest, 1 + below(62));
      const auto bits = below(4) == 0 ? 0 : below(3) == 0 ? ~std::uint64_t{0} : std::uint64_t{engine_()};
      const auto part = static_cast<std::int64_t>(bits & ((std::uint64_t{1} << count) - 1));
      x.ours = (x.ours << count) + part;
      x.reference = x.reference * two_to(count) + Residues(static_cast<std::uint64_t>(part));
      rest -= count;
    }
    if (below(2) == 0) x = {-x.ours, Residues() - x.reference};
    return x;
  }

 private:
  std::mt19937_64 engine_{20240607};
};

/// a = q b + r with |r| < |b|, and r has the sign of a: so q is cut towards zero.
void expect_cut_quotient(const Integer& q, const Integer& a, const Integer& b) {
  const Integer rest = a - q * b;
  EXPECT_TRUE(rest.sign() == 0 || rest.sign() == a.sign());
  EXPECT_LT((size_of(rest) - size_of(b)).sign(), 0);
}

TEST(Integer, agrees_with_residues_in_every_operation) {
  RandomIntegers random;
  for (int i = 0; i < 30000; ++i) {
    const int most = i % 3 == 0 ? 1000 : i % 100 == 1 ? 6000 : 130;
    const Both a = random.number(most), b = random.number(most);
    const int bits = random.below(900);
    ASSERT_TRUE(agree(a) && agree(b));
    EXPECT_TRUE(agree({a.ours + b.ours, a.reference + b.reference}));
    EXPECT_TRUE(agree({a.ours - b.ours, a.reference - b.reference}));
    EXPECT_TRUE(agree({a.ours * b.ours, a.reference * b.reference}));
    EXPECT_TRUE(agree({-a.ours, Residues() - a.reference}));
    EXPECT_TRUE(agree({a.ours << bits, a.reference * two_to(bits)}));
    EXPECT_TRUE(are_equal((a.ours << bits) >> bits, a.ours));
    expect_cut_quotient(a.ours >> bits, a.ours, Integer(1) << bits);
    if (b.ours.sign() != 0) {
      expect_cut_quotient(quotient(a.ours, b.ours), a.ours, b.ours);
      EXPECT_TRUE(are_equal(quotient(a.ours * b.ours, b.ours), a.ours));
    }
    Both c = a;
    c.ours += b.ours, c.reference = c.reference + b.reference;
    EXPECT_TRUE(agree(c));
    c.ours -= a.ours, c.reference = c.reference - a.reference;
    EXPECT_TRUE(agree(c));
    c.ours *= c.ours, c.reference = c.reference * c.reference;
    EXPECT_TRUE(agree(c));
  }
}

TEST(Integer, finds_the_greatest_common_divisor) {
  RandomIntegers random;
  for (int i = 0; i < 3000; ++i) {
    const auto a = static_cast<std::int64_t>(random.number(60).ours.bits_from(0));
    const auto b = static_cast<std::int64_t>(random.number(60).ours.bits_from(0));
    const Integer factor = random.number(i % 3 == 0 ? 1000 : 100).ours;
    const Integer common = greatest_common_divisor(factor * a, factor * -b);
    EXPECT_TRUE(are_equal(common, size_of(factor) * std::gcd(a, b)));
  }
}

/// Bits that a double has not are cut, not rounded, and the size is right.
TEST(Integer, is_cut_to_doubles) {
  RandomIntegers random;
  for (int i = 0; i < 20000; ++i) {
    const Integer a = random.number(i % 3 == 0 ? 1023 : 130).ours;
    int exponent = 0;
    const double fraction = a.fraction(exponent);
    EXPECT_EQ(a.to_double(), std::ldexp(fraction, exponent));
    if (a.sign() == 0) {
      EXPECT_EQ(fraction, 0);
      continue;
    }
    EXPECT_TRUE(0.5 <= std::fabs(fraction) && std::fabs(fraction) < 1);
    EXPECT_EQ(exponent, a.bits());
    EXPECT_EQ(size_of(a).bits_from(a.bits() - 1), 1u);
    const Integer rest = a - Integer::scaled(static_cast<std::int64_t>(std::ldexp(fraction, 53)), exponent - 53);
    EXPECT_TRUE(rest.sign() == 0 || (rest.sign() == a.sign() && rest.bits() <= a.bits() - 53));
  }
  EXPECT_EQ(((Integer(1) << 54) - 1).to_double(), 0x1p54 - 2);
  EXPECT_EQ((Integer(1) - (Integer(1) << 54)).to_double(), 2 - 0x1p54);
  EXPECT_EQ((Integer(1) << 1024).to_double(), HUGE_VAL);
}

TEST(Integer, counts_its_trailing_zeros) {
  RandomIntegers random;
  for (int zeros = 0; zeros < 1000; ++zeros) {
    const Integer odd = (random.number(300).ours << 1) + 1;
    EXPECT_EQ((odd << zeros).trailing_zeros(), zeros);
  }
}

TEST(Integer, keeps_its_value_when_copied_moved_swapped_and_relocated) {
  RandomIntegers random;
  std::vector<Both> numbers;
  for (int i = 0; i < 200; ++i) numbers.push_back(random.number(1500));  // relocates as it grows
  const auto any = [&]() -> Both& { return numbers[static_cast<std::size_t>(random.below(200))]; };
  for (int i = 0; i < 5000; ++i) {
    Both &a = any(), &b = any();
    switch (random.below(4)) {
      case 0:
        std::swap(a, b);
        break;
      case 1:
        a = b;
        break;
      case 2:
        a.ours -= b.ours, a.reference = a.reference - b.reference;
        break;
      default:
        a = Both(std::move(b));
        b = random.number(1500);
    }
    ASSERT_TRUE(agree(a) && agree(b));
  }
}

TEST(Integer, takes_every_64_bit_value) {
  for (const std::int64_t value : {std::int64_t{0}, std::int64_t{-1}, INT64_MAX, INT64_MIN}) {
    const Integer a(value);
    EXPECT_EQ(a.sign(), (value > 0) - (value < 0));
    EXPECT_EQ(a.bits_from(0), value < 0 ? 0 - static_cast<std::uint64_t>(value) : static_cast<std::uint64_t>(value));
    EXPECT_EQ(a.bits_from(64), 0u);
  }
  EXPECT_EQ(Integer(0).bits(), 1);
  EXPECT_EQ((Integer(INT64_MIN) - 1).bits_from(0), (std::uint64_t{1} << 63) + 1);
}

}  // namespace
}  // namespace tamis
