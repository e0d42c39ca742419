// The binary part of a glTF file, and the JSON that says what is where in it.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>

#include "files/output/json.hpp"

namespace tamis::io {

using FloatPoint = std::array<float, 3>;

class GlbBuffer {
 public:
  /// Each returns the number of its accessor.
  std::size_t add_points(std::span<const FloatPoint> points);
  /// Times of an animation, or the values at these times; ascending.
  std::size_t add_times(std::span<const float> times);
  std::size_t add_indices(std::span<const std::int32_t> indices);
  /// Red, green, blue, alpha in [0, 255].
  std::size_t add_colours(std::span<const std::array<std::uint8_t, 4>> colours);

  /// The file: `gltf` with buffers, views and accessors put in, then the bytes.
  std::string file(Json gltf) const;

 private:
  /// What a view is for, as glTF numbers it.
  enum class Target { none = 0, vertices = 34962, indices = 34963 };
  std::size_t add(std::span<const std::byte> bytes, Target target, int component_type, const char* type,
                  std::size_t count);

  Json views_ = Json::array();
  Json accessors_ = Json::array();
  std::string bytes_;
};

}  // namespace tamis::io
