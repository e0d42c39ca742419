#include "numbers/assert.hpp"

#ifdef TAMIS_CHECK_CONTRACTS
#include <cstdio>
#include <cstdlib>

namespace tamis {

void contract_failed(const char* file, int line, const char* condition) {
  std::fprintf(stderr, "%s:%d: a contract does not hold: %s\n", file, line, condition);
  std::abort();
}

}  // namespace tamis
#endif
