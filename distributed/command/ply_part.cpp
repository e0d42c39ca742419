#include "distributed/command/ply_part.hpp"

#include <bit>
#include <cstring>
#include <fstream>

#include "files/error.hpp"
#include "files/mesh/ply.hpp"
#include "files/mesh/ply_header.hpp"
#include "files/mesh/ply_layout.hpp"

namespace tamis::distributed {
namespace {

constexpr std::size_t kLongestHeader = 1 << 16;
/// One byte for the number of corners, and three indices.
constexpr std::size_t kTriangleBytes = 1 + 3 * sizeof(Index);

std::string read_bytes(std::ifstream& file, std::uint64_t first, std::uint64_t count) {
  std::string bytes(count, '\0');
  file.clear();
  file.seekg(static_cast<std::streamoff>(first));
  file.read(bytes.data(), static_cast<std::streamsize>(count));
  bytes.resize(static_cast<std::size_t>(file.gcount()));
  return bytes;
}

bool has_rows_of_one_size(const io::PlyElement& vertex) {
  for (const io::PlyProperty& property : vertex.properties)
    if (property.is_list) return false;
  return vertex.name == "vertex";
}

bool holds_triangles(const io::PlyElement& face) {
  if (face.name != "face" || face.properties.size() != 1) return false;
  const io::PlyProperty& corners = face.properties[0];
  const bool is_index = corners.type == io::PlyScalar::int32 || corners.type == io::PlyScalar::uint32;
  return corners.is_list && io::size_of(corners.count_type) == 1 && is_index &&
         io::places_of(face, "")[0] == io::kCorners;
}

bool can_be_read_in_parts(const io::PlyHeader& header) {
  return header.encoding == io::PlyEncoding::little_endian && std::endian::native == std::endian::little &&
         header.elements.size() == 2 && has_rows_of_one_size(header.elements[0]) && holds_triangles(header.elements[1]);
}

/// The text of a PLY file with these rows of vertices and nothing else, for the ordinary reader.
std::string file_of_vertices(std::string_view header, const io::PlyElement& vertex, std::uint64_t count,
                             const std::string& rows) {
  const std::string announced = "element vertex " + std::to_string(vertex.count);
  const std::size_t at = header.find(announced), faces = header.find("element face");
  return std::string(header.substr(0, at)) + "element vertex " + std::to_string(count) +
         std::string(header.substr(at + announced.size(), faces - at - announced.size())) + "end_header\n" + rows;
}

std::optional<std::vector<Face>> triangles_in(const std::string& rows, std::uint64_t vertices) {
  std::vector<Face> triangles(rows.size() / kTriangleBytes);
  const char* row = rows.data();
  for (Face& triangle : triangles) {
    if (row[0] != 3) return {};
    std::memcpy(triangle.data(), row + 1, sizeof(Face));
    for (const Index v : triangle)
      if (v < 0 || static_cast<std::uint64_t>(v) >= vertices) return {};
    row += kTriangleBytes;
  }
  return triangles;
}

std::optional<PlyPart> read_part(std::ifstream& file, const Block& block) {
  const std::string head = read_bytes(file, 0, kLongestHeader);
  if (!io::looks_like_ply(head)) return {};
  const io::PlyHeader header = io::parse_ply_header(head, "");
  if (!can_be_read_in_parts(header)) return {};
  const io::PlyElement &vertex = header.elements[0], &face = header.elements[1];
  std::uint64_t row = 0;
  for (const io::PlyProperty& property : vertex.properties) row += io::size_of(property.type);
  const std::uint64_t faces_start = header.bytes + vertex.count * row, size = faces_start + face.count * kTriangleBytes;
  file.clear();
  file.seekg(0, std::ios::end);
  if (static_cast<std::uint64_t>(file.tellg()) != size) return {};
  const auto rows_of = [&](std::uint64_t start, std::uint64_t rows, std::uint64_t bytes) {
    const std::uint64_t first = block.first_of(rows), count = block.last_of(rows) - first;
    return read_bytes(file, start + first * bytes, count * bytes);
  };
  const std::string vertices = rows_of(header.bytes, vertex.count, row);
  const std::string text =
      file_of_vertices(std::string_view(head).substr(0, header.bytes), vertex, vertices.size() / row, vertices);
  auto triangles = triangles_in(rows_of(faces_start, face.count, kTriangleBytes), vertex.count);
  if (!triangles) return {};
  return PlyPart{vertex.count, face.count, io::parse_ply(text, "").positions, std::move(*triangles)};
}

}  // namespace

std::optional<PlyPart> read_ply_part(const std::string& path, const Block& block) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return {};
  try {
    return read_part(file, block);
  } catch (const io::FileError&) {
    return {};
  }
}

}  // namespace tamis::distributed
