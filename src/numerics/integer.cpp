#include "numerics/integer.hpp"

namespace tamis {

void Integer::grow(int limbs) {
  const auto bits = static_cast<mp_bitcnt_t>(limbs) * GMP_NUMB_BITS;
  if (!has_own_limbs()) {
    mpz_realloc2(value_, bits);
    return;
  }
  mpz_t larger;
  mpz_init2(larger, bits);
  mpz_set(larger, value_);
  value_[0] = larger[0];
}

}  // namespace tamis
