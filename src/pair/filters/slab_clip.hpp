// Slab clip: the ray-slab test in time. On a constant axis L every difference between a point of one feature and a
// point of the other moves linearly. While all are positive, or all negative, the pair is apart. Those times are cut
// from [t_in, t_out]. If nothing remains, the pair is free. No single axis need separate it for the whole step. With a
// separation d the differences must exceed d |L|. The axes are the 13 of the 26-DOP, or the three of the coordinates.
// Error bound: error_bounds::kProjection. Cost: about 40 operations an axis.
#pragma once
#include "numbers/axes.hpp"
#include "pair/filters/filter.hpp"
#include "pair/motion/difference_corners.hpp"
#include "pair/motion/time_clip.hpp"

namespace tamis {

struct SlabClip {
  static constexpr std::string_view name = "slab";

  /// Axes of the coordinates alone leave pairs that touch nearly as little time, at a quarter of the cost.
  enum class Axes { coordinates, all };

  /// The part of `time` when the pair may touch.
  template <PairKind kind, Axes axes = Axes::all, class T>
  static TimeInterval<T> clip(const PairMotion<T>& m, const TimeInterval<T>& time) {
    TimeClip<T> clip(time);
    const T along_axis = margin_of(m, 1), planar = margin_of(m, kRootOfTwo), spatial = margin_of(m, kRootOfThree);
    for_each_axis<axes == Axes::all ? 13 : 3>([&](auto axis) {
      constexpr std::size_t i = decltype(axis)::value;
      clip_axis<kind, i>(m, i < 3 ? along_axis : i < 9 ? planar : spatial, clip);
    });
    return clip.rest();
  }

  template <PairKind kind, class T>
  static Mask<T> proves_free(const PairMotion<T>& m) {
    const auto time = clip<kind>(m, TimeInterval<T>{T(0), T(1)});
    return time.t_in > time.t_out;
  }

 private:
  /// The bound that a projected difference must exceed on an axis of this length: its error plus the separation. The
  /// separation's own rounding is below 8 u of itself.
  template <class T>
  static T margin_of(const PairMotion<T>& m, double axis_length) {
    const T error = error_bounds::bound<T>(error_bounds::kProjection, m.size_d + m.size_e + m.size_f);
    return error + constant<T>(axis_length * (1 + 8 * error_bounds::unit_roundoff<T>)) * m.separation;
  }

  template <PairKind kind, std::size_t i, class T>
  static void clip_axis(const PairMotion<T>& m, const T& margin, TimeClip<T>& clip) {
    const auto r0 = range_of_differences<kind>(project<i>(m.e.at0), project<i>(m.f.at0), project<i>(m.d.at0));
    const auto r1 = range_of_differences<kind>(project<i>(m.e.at1), project<i>(m.f.at1), project<i>(m.d.at1));
    clip.cut_positive(r0.low - margin, r1.low - margin);
    clip.cut_positive(-r0.high - margin, -r1.high - margin);
  }
};

}  // namespace tamis
