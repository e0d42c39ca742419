// The root of a cubic that falls through zero once: a guess, which pair/narrow/crossing.hpp certifies. A cubic is four
// Bernstein coefficients, the middle ones times 3 (pair/motion/polynomials.hpp). For double and for SIMD lanes.
#pragma once
#include <array>

#include "numbers/select.hpp"

namespace tamis::crossing {

template <class T>
inline T value(const std::array<T, 4>& k, const T& t) {
  const T s = T(1) - t;
  return s * s * (s * k[0] + t * k[1]) + t * t * (s * k[2] + t * k[3]);
}

/// Derivative of `value`.
template <class T>
inline T slope(const std::array<T, 4>& k, const T& t) {
  const T s = T(1) - t;
  return s * s * (k[1] - T(3) * k[0]) + T(2) * s * t * (k[2] - k[1]) + t * t * (T(3) * k[3] - k[2]);
}

/// Newton's iteration kept inside a shrinking bracket, one iterate() at a time. It converges to one of the roots if
/// k[0] > 0 > k[3]. Else goes_on() is false from the start, and root() means nothing.
template <class T>
class RootSearch {
 public:
  explicit RootSearch(const std::array<T, 4>& k)
      : c0_(k[0]),
        c1_(k[1] - T(3) * k[0]),
        c2_(T(3) * k[0] - T(2) * k[1] + k[2]),
        c3_((k[3] - k[0]) + (k[1] - k[2])),
        root_(k[0] / (k[0] - k[3])),
        goes_on_((k[0] > T(0)) & (k[3] < T(0))) {}

  const Mask<T>& goes_on() const { return goes_on_; }
  const T& root() const { return root_; }

  void iterate() {
    // After a last correction of d the root is off by at most kBend d^2 / fall: a third of the distance within which
    // the sign is certain.
    const T tolerance(0x1p-27), square = root_ * root_;
    const T f = (c0_ + c1_ * root_) + square * (c2_ + c3_ * root_);
    const T slope = (c1_ + T(2) * c2_ * root_) + T(3) * c3_ * square;
    low_ = select(f > T(0), root_, low_);
    high_ = select(f > T(0), high_, root_);
    const T newton = root_ - f / slope;
    const T next = select((newton >= low_) & (newton <= high_), newton, T(0.5) * (low_ + high_));
    const auto moves = abs(next - root_) > tolerance * root_;
    root_ = select(goes_on_, next, root_);
    goes_on_ = goes_on_ & moves & (f != T(0));
  }

 private:
  const T c0_, c1_, c2_, c3_;  // coefficients of the powers of t
  T low_ = T(0), high_ = T(1), root_;
  Mask<T> goes_on_;
};

inline constexpr int kMaxIterations = 60;

template <class T>
inline T find_root(const std::array<T, 4>& k) {
  RootSearch<T> search(k);
  for (int i = 0; i < kMaxIterations && any(search.goes_on()); ++i) search.iterate();
  return search.root();
}

/// The roots of two cubics, interleaved. The divisions of one run while the other's are waited for.
template <class T>
inline std::array<T, 2> find_two_roots(const std::array<T, 4>& k, const std::array<T, 4>& other) {
  RootSearch<T> a(k), b(other);
  for (int i = 0; i < kMaxIterations && any(Mask<T>(a.goes_on() | b.goes_on())); ++i) {
    a.iterate();
    b.iterate();
  }
  return {a.root(), b.root()};
}

}  // namespace tamis::crossing
