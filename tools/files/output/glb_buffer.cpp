#include "files/output/glb_buffer.hpp"

#include <algorithm>

namespace tamis::io {
namespace {

// As glTF numbers them.
constexpr int kUnsignedByte = 5121;
constexpr int kUnsignedInt = 5125;
constexpr int kFloat = 5126;

void append_word(std::string& bytes, std::size_t word) {
  for (std::size_t byte = 0; byte < 4; ++byte) bytes += static_cast<char>((word >> (8 * byte)) & 0xff);
}

/// Pads to whole words of four bytes, as glTF requires of chunks.
void pad(std::string& bytes, char with) {
  while (bytes.size() % 4 != 0) bytes += with;
}

void append_chunk(std::string& file, std::size_t type, const std::string& bytes) {
  append_word(file, bytes.size());
  append_word(file, type);
  file += bytes;
}

}  // namespace

std::size_t GlbBuffer::add(std::span<const std::byte> bytes, Target target, int component_type, const char* type,
                           std::size_t count) {
  views_.push_back({{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", bytes.size()}});
  if (target != Target::none) views_.back()["target"] = target;
  accessors_.push_back(
      {{"bufferView", views_.size() - 1}, {"componentType", component_type}, {"count", count}, {"type", type}});
  // glTF is little-endian, as are the machines that Tamis runs on.
  bytes_.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  return accessors_.size() - 1;
}

std::size_t GlbBuffer::add_points(std::span<const FloatPoint> points) {
  const std::size_t accessor = add(std::as_bytes(points), Target::vertices, kFloat, "VEC3", points.size());
  FloatPoint lowest = points.front(), highest = points.front();
  for (const FloatPoint& point : points)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      lowest[axis] = std::min(lowest[axis], point[axis]);
      highest[axis] = std::max(highest[axis], point[axis]);
    }
  accessors_[accessor]["min"] = lowest;
  accessors_[accessor]["max"] = highest;
  return accessor;
}

std::size_t GlbBuffer::add_times(std::span<const float> times) {
  const std::size_t accessor = add(std::as_bytes(times), Target::none, kFloat, "SCALAR", times.size());
  accessors_[accessor]["min"] = {times.front()};
  accessors_[accessor]["max"] = {times.back()};
  return accessor;
}

std::size_t GlbBuffer::add_indices(std::span<const std::int32_t> indices) {
  return add(std::as_bytes(indices), Target::indices, kUnsignedInt, "SCALAR", indices.size());
}

std::size_t GlbBuffer::add_colours(std::span<const std::array<std::uint8_t, 4>> colours) {
  const std::size_t accessor = add(std::as_bytes(colours), Target::vertices, kUnsignedByte, "VEC4", colours.size());
  accessors_[accessor]["normalized"] = true;
  return accessor;
}

std::string GlbBuffer::file(Json gltf) const {
  gltf["buffers"] = Json::array({{{"byteLength", bytes_.size()}}});
  gltf["bufferViews"] = views_;
  gltf["accessors"] = accessors_;
  std::string text = gltf.dump(), bytes = bytes_;
  pad(text, ' ');
  pad(bytes, '\0');
  constexpr std::size_t kMagic = 0x46546C67, kVersion = 2, kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;
  constexpr std::size_t kHeaders = 12 + 2 * 8;
  std::string file;
  append_word(file, kMagic);
  append_word(file, kVersion);
  append_word(file, kHeaders + text.size() + bytes.size());
  append_chunk(file, kJsonChunk, text);
  append_chunk(file, kBinaryChunk, bytes);
  return file;
}

}  // namespace tamis::io
