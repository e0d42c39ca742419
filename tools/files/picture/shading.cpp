#include "files/picture/shading.hpp"

namespace tamis::io {

float sky_at(const Drawing& surfaces, const Place& place, float turn, std::size_t part) {
  constexpr std::size_t kRays = 16, kParts = 4;
  constexpr float kGolden = 2.3999632F;  // the angle between two rays, in radians: they never line up
  constexpr float kReach = 0.7F;         // in units of half the scene; farther things take no light
  constexpr float kOff = 1e-4F;          // so that a place does not hide itself
  const Vector& n = place.normal;
  const Vector side = unit(cross(std::abs(n[0]) > 0.5F ? Vector{0, 1, 0} : Vector{1, 0, 0}, n)), other = cross(n, side);
  std::size_t free = 0;
  for (std::size_t i = part; i < kRays; i += kParts) {
    // Rays are denser about the normal, as light from there counts most.
    const float radius = std::sqrt((static_cast<float>(i) + 0.5F) / kRays),
                angle = turn + kGolden * static_cast<float>(i);
    const Vector direction =
        radius * (std::cos(angle) * side + std::sin(angle) * other) + std::sqrt(1 - radius * radius) * n;
    free += surfaces.meets_any({place.point + kOff * n, unit(direction), kOff}, kReach) ? 0 : 1;
  }
  return static_cast<float>(free) / (kRays / kParts);
}

}  // namespace tamis::io
