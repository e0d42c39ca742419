// What compilers and processors name differently. No other file asks which compiler or processor this is:
// scripts/check_platform.py. g++ and clang are tested. MSVC's half is written from its documentation, and untested.
#pragma once
#include <cfloat>
#include <cstdint>

#if defined(_MSC_VER)
#include <intrin.h>
#endif

// Error bounds hold only where products, sums and comparisons follow IEEE 754.
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0) || \
    defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || defined(__NO_SIGNED_ZEROS__)
#error \
    "Tamis is compiled with -ffast-math or a part of it, and would miss contacts: add -fno-fast-math behind that option"
#endif
#if defined(_M_FP_FAST) || (defined(_MSC_VER) && !defined(__clang__) && _MSC_VER < 1930)
#error \
    "Tamis is compiled with /fp:fast, or by an MSVC that fuses products and sums, and would miss contacts: add /fp:precise behind that option, and take Visual Studio 2022 or newer"
#endif
#if FLT_EVAL_METHOD != 0
#error \
    "Tamis is compiled where doubles are computed with another precision, and would miss contacts: add -mfpmath=sse -msse2"
#endif

// Inlined whatever the compiler thinks. Begins a function's declaration.
#if defined(_MSC_VER) && !defined(__clang__)
#define TAMIS_ALWAYS_INLINE __forceinline
#else
#define TAMIS_ALWAYS_INLINE [[gnu::always_inline]] inline
#endif

namespace tamis {

/// Begins to load the cache line at `address`, which may be any.
TAMIS_ALWAYS_INLINE void prefetch(const void* address) {
#if !defined(_MSC_VER) || defined(__clang__)
  __builtin_prefetch(address);
#elif defined(_M_X64)
  _mm_prefetch(static_cast<const char*>(address), _MM_HINT_T0);
#else
  __prefetch(address);
#endif
}

/// The higher 64 bits of a product. The lower are a * b.
TAMIS_ALWAYS_INLINE std::uint64_t high_product(std::uint64_t a, std::uint64_t b) {
#if defined(__SIZEOF_INT128__)
  __extension__ using Wide = unsigned __int128;
  return static_cast<std::uint64_t>(Wide{a} * b >> 64);
#elif defined(_MSC_VER)
  return __umulh(a, b);
#else
#error "Tamis needs a compiler with 128-bit products: g++, clang or MSVC for a 64-bit machine, or for WebAssembly"
#endif
}

/// The bits of a thread's registers that decide how results round, which subnormal numbers are zero, and which results
/// raise a signal. The default: to nearest, nothing flushed, no signal.
#if defined(__x86_64__) || (defined(_M_X64) && !defined(_M_ARM64EC))
struct FloatingPointState {
  std::uint32_t sse = 0x1f80;  ///< of MXCSR all but the flags that tell what has happened
  std::uint32_t x87 = 0;       ///< of the control word the two bits of the rounding direction, which strtod reads
  bool operator==(const FloatingPointState&) const = default;
};

#if defined(_MSC_VER) && !defined(__clang__)  // nothing of its uses x87
inline FloatingPointState floating_point_state() { return {_mm_getcsr() & 0xffc0U, 0}; }
inline void set_floating_point_state(const FloatingPointState& state) {
  _mm_setcsr((_mm_getcsr() & ~0xffc0U) | state.sse);
}
#else
inline FloatingPointState floating_point_state() {
  std::uint32_t sse = 0;
  std::uint16_t x87 = 0;
  asm volatile("stmxcsr %0\n\tfnstcw %1" : "=m"(sse), "=m"(x87) : : "memory");
  return {sse & 0xffc0U, x87 & 0x0c00U};
}
/// Leaves all other bits as they are.
inline void set_floating_point_state(const FloatingPointState& state) {
  std::uint32_t sse = 0;
  std::uint16_t x87 = 0;
  asm volatile("stmxcsr %0\n\tfnstcw %1" : "=m"(sse), "=m"(x87) : : "memory");
  sse = (sse & ~0xffc0U) | state.sse;
  x87 = static_cast<std::uint16_t>((x87 & ~0x0c00U) | state.x87);
  asm volatile("ldmxcsr %0\n\tfldcw %1" : : "m"(sse), "m"(x87) : "memory");
}
#endif
#elif defined(__aarch64__) || defined(_M_ARM64)
struct FloatingPointState {
  std::uint64_t fpcr = 0;
  bool operator==(const FloatingPointState&) const = default;
};

#if defined(_MSC_VER) && !defined(__clang__)
inline FloatingPointState floating_point_state() { return {static_cast<std::uint64_t>(_ReadStatusReg(ARM64_FPCR))}; }
inline void set_floating_point_state(const FloatingPointState& state) {
  _WriteStatusReg(ARM64_FPCR, static_cast<__int64>(state.fpcr));
}
#else
inline FloatingPointState floating_point_state() {
  std::uint64_t fpcr = 0;
  asm volatile("mrs %0, fpcr" : "=r"(fpcr) : : "memory");
  return {fpcr};
}
inline void set_floating_point_state(const FloatingPointState& state) {
  asm volatile("msr fpcr, %0" : : "r"(state.fpcr) : "memory");
}
#endif
#elif defined(__wasm__)
/// WebAssembly has one state, this one.
struct FloatingPointState {
  bool operator==(const FloatingPointState&) const = default;
};
inline FloatingPointState floating_point_state() { return {}; }
inline void set_floating_point_state(const FloatingPointState&) {}
#else
#error \
    "Tamis does not know this processor's floating-point state, which its proofs need: add its register to numbers/platform.hpp (x86-64, 64-bit ARM and WebAssembly are there)"
#endif

#if defined(__x86_64__) || (defined(_M_X64) && !defined(_M_ARM64EC))
/// True if processor and system have these instructions. A system without their registers would not save them.
#if defined(_MSC_VER)  // clang-cl links no library for __builtin_cpu_supports
inline bool has_features(std::uint64_t saved, int of_leaf_7) {
  int regs[4];
  __cpuid(regs, 0);
  if (regs[0] < 7) return false;
  __cpuid(regs, 1);
  constexpr int kOfLeaf1 = 1 << 12 | 1 << 22 | 1 << 23 | 1 << 27;  // fma, movbe and popcnt, as /arch:AVX2 uses; xgetbv
  if ((regs[2] & kOfLeaf1) != kOfLeaf1 || (_xgetbv(0) & saved) != saved) return false;
  __cpuidex(regs, 7, 0);
  return (regs[1] & of_leaf_7) == of_leaf_7;
}
inline bool has_avx2() { return has_features(0x06, 1 << 3 | 1 << 5 | 1 << 8); }  // bmi1, avx2, bmi2
inline bool has_avx512() {                                                       // f, dq, cd, bw, vl
  return has_avx2() && has_features(0xe6, static_cast<int>(1U << 16 | 1U << 17 | 1U << 28 | 1U << 30 | 1U << 31));
}
#else
inline bool has_avx2() { return __builtin_cpu_supports("avx2"); }
inline bool has_avx512() {
  return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512cd") &&
         __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl");
}
#endif
#endif

}  // namespace tamis
