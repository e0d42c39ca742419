#include "numbers/integer.hpp"

namespace tamis {

void Integer::grow(int limbs) {
  mpz_t larger;
  mpz_init2(larger, static_cast<mp_bitcnt_t>(limbs) * GMP_NUMB_BITS);
  mpz_set(larger, value_);
  release();
  value_[0] = larger[0];
}

}  // namespace tamis
