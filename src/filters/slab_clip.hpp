// Slab clip: the ray-slab test in time. On a constant axis L every difference between a point of one feature and a
// point of the other moves linearly; while all are positive, or all negative, the pair is apart. Those times are cut
// from [t_in, t_out]; nothing left means the pair is free, and no single axis need separate it for the whole step.
// The axes are the 13 of the 26-DOP, or the first of them.
// Error bound: error_bounds::kProjection. Cost: about 40 operations an axis.
#pragma once
#include "filters/filter.hpp"
#include "motion/time_clip.hpp"

namespace tamis {

struct SlabClip {
  static constexpr std::string_view name = "slab";

  /// The part of `time` in which the pair may touch.
  template <PairKind kind, class T>
  static TimeInterval<T> clip(const PairMotion<T>& m, const TimeInterval<T>& time) {
    const T error = error_of(m);
    TimeClip<T> clip(time);
    const auto clip_along = [&](const auto& along) { clip_axis<kind>(m, along, error, clip); };
    for_each_coordinate_axis(clip_along);
    for_each_diagonal_axis(clip_along);
    return clip.rest();
  }

  /// The same on the ten diagonal axes only: the boxes have seen to the other three.
  template <PairKind kind, class T>
  static TimeInterval<T> clip_diagonals(const PairMotion<T>& m, const TimeInterval<T>& time) {
    const T error = error_of(m);
    TimeClip<T> clip(time);
    for_each_diagonal_axis([&](const auto& along) { clip_axis<kind>(m, along, error, clip); });
    return clip.rest();
  }

  template <PairKind kind, class T>
  static Mask<T> proves_free(const PairMotion<T>& m) {
    const auto time = clip<kind>(m, TimeInterval<T>{T(0), T(1)});
    return time.t_in > time.t_out;
  }

 private:
  template <class T>
  static T error_of(const PairMotion<T>& m) {
    return error_bounds::bound<T>(error_bounds::kProjection, m.size_d + m.size_e + m.size_f);
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
  static void clip_axis(const PairMotion<T>& m, const Along& along, const T& error, TimeClip<T>& clip) {
    const auto r0 = range<kind>(along(m.e.at0), along(m.f.at0), along(m.d.at0));
    const auto r1 = range<kind>(along(m.e.at1), along(m.f.at1), along(m.d.at1));
    clip.cut_positive(r0.low - error, r1.low - error);
    clip.cut_positive(-r0.high - error, -r1.high - error);
  }
};

}  // namespace tamis
