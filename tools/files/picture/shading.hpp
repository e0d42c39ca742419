// Light and colours.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "files/output/colours.hpp"
#include "files/picture/camera.hpp"

namespace tamis::io {

/// Intensities of red, green and blue as light adds up; a screen's numbers are not proportional to them.
using Light = Vector;

inline Light light_of(const Rgb& screen) {
  const auto linear = [](std::uint8_t c) { return std::pow(static_cast<float>(c) / 255, 2.2F); };
  return {linear(screen[0]), linear(screen[1]), linear(screen[2])};
}

inline Rgb screen_of(const Light& light) {
  const auto shown = [](float x) {
    return static_cast<std::uint8_t>(std::lround(255 * std::pow(std::clamp(x, 0.0F, 1.0F), 1 / 2.2F)));
  };
  return {shown(light[0]), shown(light[1]), shown(light[2])};
}

inline Light mix(const Light& a, const Light& b, float part) { return (1 - part) * a + part * b; }

/// A place that is seen: where it is, its normal towards the eye, and which of its sides that is.
struct Place {
  Vector point;
  Vector normal;
  bool is_back = false;
};

inline Place place_of(const Ray& sight, const Hit& hit) {
  const bool is_back = dot(hit.normal, sight.direction) > 0;
  return {sight.origin + hit.distance * sight.direction, is_back ? -1.0F * hit.normal : hit.normal, is_back};
}

/// How much of the sky a place sees, from 0 to 1, by four of sixteen rays; `part`, from 0 to 3, chooses the four.
/// `turn`: an angle that differs from place to place, so that the error is noise and no pattern.
float sky_at(const Drawing& surfaces, const Place& place, float turn, std::size_t part);

/// The light that a surface of this colour sends to the eye.
inline Light shaded(const Light& colour, const Place& place, float sky, const Camera& camera) {
  const Vector lamp = unit(camera.back() + 1.1F * camera.up() - 0.8F * camera.right());
  const float light = 0.06F + 0.3F * sky + 0.75F * std::max(0.0F, dot(place.normal, lamp)) * (0.3F + 0.7F * sky);
  // As in the viewer, the back of a surface is darker and warmer.
  const Light side = place.is_back ? Light{0.80F, 0.66F, 0.55F} : Light{1, 1, 1};
  return {light * side[0] * colour[0], light * side[1] * colour[1], light * side[2] * colour[2]};
}

}  // namespace tamis::io
