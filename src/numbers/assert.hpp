// Contracts. A condition that a comment calls REQUIRES is checked in the tests' build if the check costs O(1).
#pragma once

// TAMIS_ASSERT(condition): where TAMIS_CHECK_CONTRACTS is defined, a condition that does not hold is printed with its
// place. Then the program aborts. Elsewhere it is compiled and not evaluated. Kernels are compiled without checks.
#ifdef TAMIS_CHECK_CONTRACTS
namespace tamis {
/// Not inline. So no object of one instruction set can offer the linker a copy of it.
[[noreturn]] void contract_failed(const char* file, int line, const char* condition);
}  // namespace tamis
#define TAMIS_ASSERT(...) \
  (static_cast<bool>(__VA_ARGS__) ? void() : ::tamis::contract_failed(__FILE__, __LINE__, #__VA_ARGS__))
#else
#define TAMIS_ASSERT(...) static_cast<void>(sizeof(static_cast<bool>(__VA_ARGS__)))
#endif
