// The floating-point states in which callers may call, set without the library's own code.
#pragma once
#include <gtest/gtest.h>

#include <bit>
#include <cfenv>
#include <cstdint>
#include <string>
#include <thread>
#include <vector>
#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

namespace tamis::test {

struct CallerState {
  const char* name;
  int direction;
  bool flushes;  ///< takes subnormal numbers for zero (FTZ and DAZ)
};
inline constexpr CallerState kCallerStates[]{
    {"to nearest", FE_TONEAREST, false},
    {"downward", FE_DOWNWARD, false},
    {"upward", FE_UPWARD, false},
    {"towards zero", FE_TOWARDZERO, false},
    {"to nearest, flushing", FE_TONEAREST, true},
    {"downward, flushing", FE_DOWNWARD, true},
};

inline void set(const CallerState& state) {
  std::fesetround(state.direction);
#if defined(__x86_64__)
  constexpr unsigned kFlushes = 0x8040;
  _mm_setcsr(state.flushes ? _mm_getcsr() | kFlushes : _mm_getcsr() & ~kFlushes);
#elif defined(__aarch64__)
  constexpr std::uint64_t kFlushes = std::uint64_t{1} << 24;
  std::uint64_t fpcr = 0;
  asm volatile("mrs %0, fpcr" : "=r"(fpcr));
  asm volatile("msr fpcr, %0" : : "r"(state.flushes ? fpcr | kFlushes : fpcr & ~kFlushes));
#endif
}

/// Shows in results, whatever register decides.
inline std::string state_here() {
  volatile double one = 1, tiny = 0x1p-60, least = 0x1p-1074, two = 2;
  const bool is_up = one + tiny > 1, is_down = one - tiny < 1 && -one - tiny < -1, is_to_zero = one - tiny < 1;
  const std::uint64_t doubled = std::bit_cast<std::uint64_t>(least * two);
  const char* direction = is_up ? "upward" : is_down ? "downward" : is_to_zero ? "towards zero" : "to nearest";
  return std::string(direction) + (doubled == 0 ? ", flushing" : "") + (std::fegetround() == FE_TONEAREST ? "" : " ");
}

/// Calls f() in a new thread with this state: oneTBB keeps the state in which a thread first uses it. Returns the state
/// afterwards.
template <class F>
std::string in_state(const CallerState& state, const F& f) {
  std::string after;
  std::thread([&] {
    set(state);
    f();
    after = state_here();
  }).join();
  return after;
}

inline std::vector<std::uint64_t> bits_of(const std::vector<double>& numbers) {
  std::vector<std::uint64_t> bits;
  for (const double number : numbers) bits.push_back(std::bit_cast<std::uint64_t>(number));
  return bits;
}

/// ask() returns the same numbers in all states, bit for bit, and leaves the state as it was.
template <class Ask>
void expect_same_in_all_states(const std::string& what, const Ask& ask) {
  std::vector<double> expected;
  for (const CallerState& state : kCallerStates) {
    std::vector<double> found;
    std::string before;
    const std::string after = in_state(state, [&] {
      before = state_here();
      found = ask();
    });
    EXPECT_EQ(after, before) << what << ", " << state.name;
    if (&state == kCallerStates) expected = found;
    EXPECT_EQ(bits_of(found), bits_of(expected)) << what << ", " << state.name;
  }
}

}  // namespace tamis::test
