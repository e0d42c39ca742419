// Integer against mpz_class, on sizes around the border between its own limbs and the heap: a reservation that is too
// small, or a move that leaves a pointer into the old place, would show here (and abort under the address sanitizer).
#include "numbers/integer.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace tamis {
namespace {

struct Both {
  Integer ours;
  mpz_class reference;
};

bool agree(const Both& x) { return mpz_cmp(x.ours.get(), x.reference.get_mpz_t()) == 0; }

class RandomIntegers {
 public:
  RandomIntegers() : source_(gmp_randinit_default) { source_.seed(20240607); }

  unsigned long below(unsigned long bound) { return mpz_class(source_.get_z_range(bound)).get_ui(); }
  Both number(unsigned long most_bits) {
    Both x;
    x.reference = source_.get_z_bits(below(most_bits + 1));
    if (below(2) == 0) x.reference = -x.reference;
    x.ours.assign(x.reference.get_mpz_t());
    return x;
  }

 private:
  gmp_randclass source_;
};

TEST(Integer, agrees_with_gmp_in_every_operation) {
  RandomIntegers random;
  for (int i = 0; i < 60000; ++i) {
    const unsigned long most = i % 3 == 0 ? 1000 : 130;  // a few limbs go another way than many
    const Both a = random.number(most), b = random.number(most);
    const unsigned long bits = random.below(900);
    EXPECT_TRUE(agree({a.ours + b.ours, a.reference + b.reference}));
    EXPECT_TRUE(agree({a.ours - b.ours, a.reference - b.reference}));
    EXPECT_TRUE(agree({a.ours * b.ours, a.reference * b.reference}));
    EXPECT_TRUE(agree({-a.ours, -a.reference}));
    EXPECT_TRUE(agree({greatest_common_divisor(a.ours, b.ours), gcd(a.reference, b.reference)}));
    if (b.ours.sign() != 0) {
      EXPECT_TRUE(agree({exact_quotient(a.ours * b.ours, b.ours), a.reference}));
    }
    EXPECT_TRUE(agree({a.ours << bits, a.reference << bits}));
    EXPECT_TRUE(agree({(a.ours << bits) >> bits, a.reference}));
    Both c = a;
    c.ours += b.ours, c.reference += b.reference;
    EXPECT_TRUE(agree(c));
    c.ours -= a.ours, c.reference -= a.reference;
    EXPECT_TRUE(agree(c));
    EXPECT_EQ(a.ours.sign(), sgn(a.reference));
    EXPECT_EQ(a.ours.to_double(), a.reference.get_d());
  }
}

TEST(Integer, keeps_its_value_when_copied_moved_swapped_and_relocated) {
  RandomIntegers random;
  std::vector<Both> numbers;
  for (int i = 0; i < 200; ++i) numbers.push_back(random.number(1500));  // relocates as it grows
  for (int i = 0; i < 5000; ++i) {
    Both& a = numbers[random.below(200)];
    Both& b = numbers[random.below(200)];
    switch (random.below(4)) {
      case 0:
        std::swap(a, b);
        break;
      case 1:
        a = b;
        break;
      case 2:
        a.ours -= b.ours, a.reference -= b.reference;
        break;
      default:
        a = Both(std::move(b));
        b = random.number(1500);
    }
    ASSERT_TRUE(agree(a) && agree(b));
  }
}

TEST(Integer, takes_every_64_bit_value) {
  EXPECT_TRUE(agree({Integer(0), 0}));
  EXPECT_TRUE(agree({Integer(-1), -1}));
  EXPECT_TRUE(agree({Integer(INT64_MAX), mpz_class("9223372036854775807")}));
  EXPECT_TRUE(agree({Integer(INT64_MIN), mpz_class("-9223372036854775808")}));
}

}  // namespace
}  // namespace tamis
