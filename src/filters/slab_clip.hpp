// Slab clip: the ray-slab test in time. On a constant axis L every difference between a point of one feature and a
// point of the other moves linearly; while all are positive, or all negative, the pair is apart. Those times are cut
// from [t_in, t_out]; nothing left means the pair is free, and no single axis need separate it for the whole step.
// The axes are the 13 of the 26-DOP, or the first of them.
// Error bound: error_bounds::kProjection. Cost: about 40 operations an axis.
#pragma once
#include "filters/filter.hpp"
#include "numerics/select.hpp"

namespace tamis {

/// A part of the step; empty if t_in > t_out.
template <class T>
struct TimeInterval {
  T t_in, t_out;
};

struct SlabClip {
  static constexpr std::string_view name = "slab";

  /// The part of `time` in which the pair may touch.
  template <PairKind kind, class T>
  static TimeInterval<T> clip(const PairMotion<T>& m, TimeInterval<T> time) {
    const T error = error_of(m);
    const auto clip_along = [&](const auto& along) { clip_axis<kind>(m, along, error, time); };
    for_each_coordinate_axis(clip_along);
    for_each_diagonal_axis(clip_along);
    return time;
  }

  /// The same on the ten diagonal axes only: the boxes have seen to the other three.
  template <PairKind kind, class T>
  static TimeInterval<T> clip_diagonals(const PairMotion<T>& m, TimeInterval<T> time) {
    const T error = error_of(m);
    for_each_diagonal_axis([&](const auto& along) { clip_axis<kind>(m, along, error, time); });
    return time;
  }

  template <PairKind kind, class T>
  static Mask<T> proves_free(const PairMotion<T>& m) {
    const auto time = clip<kind>(m, TimeInterval<T>{T(0), T(1)});
    return time.t_in > time.t_out;
  }

  /// Cuts the times at which the linear function from g0 (t=0) to g1 (t=1) is positive. The quotient is off by
  /// 2 u of itself; 4 u are given.
  template <class T>
  static void cut_positive(const T& g0, const T& g1, TimeInterval<T>& time) {
    const T zero(0), root = g0 / (g0 - g1);
    const auto starts = g0 > zero, ends = g1 > zero;
    time.t_in = select(starts, select(ends, T(2), max(time.t_in, root * T(1 - 0x1p-51))), time.t_in);
    time.t_out = select(ends, min(time.t_out, root * T(1 + 0x1p-51)), time.t_out);
  }

 private:
  template <class T>
  static T error_of(const PairMotion<T>& m) {
    return T(error_bounds::kProjection) * (m.size_d + m.size_e + m.size_f) + T(error_bounds::kUnderflow);
  }

  template <class F>
  static void for_each_coordinate_axis(const F& f) {
    f([](const auto& v) { return v.x; });
    f([](const auto& v) { return v.y; });
    f([](const auto& v) { return v.z; });
  }

  template <class F>
  static void for_each_diagonal_axis(const F& f) {
    f([](const auto& v) { return v.x + v.y; });
    f([](const auto& v) { return v.x - v.y; });
    f([](const auto& v) { return v.x + v.z; });
    f([](const auto& v) { return v.x - v.z; });
    f([](const auto& v) { return v.y + v.z; });
    f([](const auto& v) { return v.y - v.z; });
    f([](const auto& v) { return v.x + v.y + v.z; });
    f([](const auto& v) { return v.x + v.y - v.z; });
    f([](const auto& v) { return v.x - v.y + v.z; });
    f([](const auto& v) { return v.x - v.y - v.z; });
  }

  /// Smallest and largest projected difference between the two features.
  template <class T>
  struct Range {
    T low, high;
  };

  template <PairKind kind, class T>
  static Range<T> range(const T& e, const T& f, const T& d) {
    const T zero(0);
    if constexpr (kind == PairKind::vertex_face)  // d, d - e, d - f
      return {d - max(zero, max(e, f)), d - min(zero, min(e, f))};
    else  // d + {0, f} - {0, e}
      return {d + min(zero, f) - max(zero, e), d + max(zero, f) - min(zero, e)};
  }

  template <PairKind kind, class T, class Along>
  static void clip_axis(const PairMotion<T>& m, const Along& along, const T& error, TimeInterval<T>& time) {
    const auto r0 = range<kind>(along(m.e.at0), along(m.f.at0), along(m.d.at0));
    const auto r1 = range<kind>(along(m.e.at1), along(m.f.at1), along(m.d.at1));
    cut_positive(r0.low - error, r1.low - error, time);
    cut_positive(-r0.high - error, -r1.high - error, time);
  }
};

}  // namespace tamis
