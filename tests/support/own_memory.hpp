// Operators new and delete that first call on_allocation() of the test. Only one source of a program includes this.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace tamis::test {

/// Defined by the test. It may throw std::bad_alloc.
void on_allocation();

inline void* allocated(std::size_t size, std::size_t unit) {
  on_allocation();
#if defined(_WIN32)
  void* const piece = _aligned_malloc(std::max<std::size_t>(size, 1), unit);
#else
  void* const piece = std::aligned_alloc(unit, (std::max<std::size_t>(size, 1) + unit - 1) / unit * unit);
#endif
  if (piece == nullptr) throw std::bad_alloc();
  return piece;
}

// Inlined, it would look to GCC like free() of what new gave.
[[gnu::noinline]] inline void release(void* piece) noexcept {
#if defined(_WIN32)
  _aligned_free(piece);
#else
  std::free(piece);
#endif
}

}  // namespace tamis::test

void* operator new(std::size_t size) { return tamis::test::allocated(size, alignof(std::max_align_t)); }
void* operator new(std::size_t size, std::align_val_t unit) {
  return tamis::test::allocated(size, static_cast<std::size_t>(unit));
}
void operator delete(void* piece) noexcept { tamis::test::release(piece); }
void operator delete(void* piece, std::size_t) noexcept { tamis::test::release(piece); }
void operator delete(void* piece, std::align_val_t) noexcept { tamis::test::release(piece); }
void operator delete(void* piece, std::size_t, std::align_val_t) noexcept { tamis::test::release(piece); }
