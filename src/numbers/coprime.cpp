#include <utility>

#include "numbers/assert.hpp"
#include "numbers/integer_polynomial.hpp"

namespace tamis {
namespace {

/// The largest prime below 2^32: products fit into 64 bits. Modulo 2^31-1 powers of two would have only 31 values.
constexpr std::uint64_t kPrime = 4294967291;

std::uint64_t times(std::uint64_t a, std::uint64_t b) { return a * b % kPrime; }
std::uint64_t minus(std::uint64_t a, std::uint64_t b) { return a >= b ? a - b : a + kPrime - b; }

std::uint64_t residue(const Integer& a) {
  constexpr int kDigit = 32;
  constexpr std::uint64_t kMask = 0xffffffff;
  std::uint64_t size = 0;
  for (int first = a.bits() / kDigit * kDigit; first >= 0; first -= kDigit)
    size = ((size << kDigit) + (a.bits_from(first) & kMask)) % kPrime;
  return a.sign() < 0 ? minus(0, size) : size;
}

struct Residues {
  std::array<std::uint64_t, IntegerPolynomial::kMaxDegree + 1> powers{};
  int degree = -1;

  explicit Residues(const IntegerPolynomial& p) : degree(p.degree()) {
    for (int i = 0; i <= degree; ++i) at(i) = residue(p[i]);
  }
  std::uint64_t& at(int i) { return powers[static_cast<std::size_t>(i)]; }
  bool has_lost_degree() { return at(degree) == 0; }

  /// Becomes the remainder, modulo b, of this polynomial times a power of b's leading coefficient.
  void reduce_modulo(Residues& b) {
    while (degree >= b.degree) {
      const std::uint64_t leading = at(degree);
      const int shift = degree - b.degree;
      for (int i = 0; i < degree; ++i) {
        at(i) = times(at(i), b.at(b.degree));
        if (i >= shift) at(i) = minus(at(i), times(leading, b.at(i - shift)));
      }
      at(degree) = 0;
      while (degree >= 0 && at(degree) == 0) --degree;
    }
  }
};

}  // namespace

bool are_surely_coprime(const IntegerPolynomial& p, const IntegerPolynomial& q) {
  TAMIS_ASSERT(!p.is_zero() && !q.is_zero());
  Residues a(p), b(q);
  if (a.has_lost_degree() || b.has_lost_degree()) return false;
  if (a.degree < b.degree) std::swap(a, b);
  while (b.degree > 0) {
    a.reduce_modulo(b);
    std::swap(a, b);
  }
  return b.degree == 0;
}

}  // namespace tamis
