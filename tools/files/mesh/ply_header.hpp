// The header of a PLY file: what the body holds, and in which order.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tamis::io {

enum class PlyEncoding : std::uint8_t { ascii, little_endian, big_endian };
enum class PlyScalar : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct PlyProperty {
  std::string name;
  PlyScalar type = PlyScalar::float64;
  bool is_list = false;
  PlyScalar count_type = PlyScalar::uint8;  ///< of a list's length; an integer type
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::size_t line = 0;  ///< where the header announces it
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::ascii;
  std::vector<PlyElement> elements;
  std::size_t bytes = 0;  ///< the body starts here
  std::size_t lines = 0;
};

std::size_t size_of(PlyScalar type);

/// Throws FileError.
PlyHeader parse_ply_header(std::string_view bytes, const std::string& name);

}  // namespace tamis::io
