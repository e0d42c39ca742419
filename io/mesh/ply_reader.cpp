// The body of a PLY file, element by element, as its header announces it.
#include <algorithm>
#include <cmath>
#include <limits>

#include "io/mesh/ply.hpp"
#include "io/mesh/ply_layout.hpp"
#include "io/mesh/ply_source.hpp"
#include "io/mesh/polygons.hpp"

namespace tamis::io {
namespace {

template <class Source>
class BodyReader {
 public:
  BodyReader(const PlyHeader& header, std::string_view bytes, const std::string& name)
      : header_(header), bytes_(bytes), name_(name), source_(bytes.substr(header.bytes), header, name) {}

  MeshFile read() {
    vertex_count_ = count_vertices();
    for (const PlyElement& element : header_.elements) read_element(element);
    source_.end();
    polygons_.note(mesh_);
    if (header_.encoding == PlyEncoding::ascii) note_open_end(bytes_, mesh_);
    return std::move(mesh_);
  }

 private:
  Index count_vertices() const {
    for (const PlyElement& e : header_.elements) {
      if (e.name != "vertex") continue;
      if (e.count > static_cast<std::uint64_t>(std::numeric_limits<Index>::max()))
        fail(e, "more vertices than a 32-bit index can name: split the mesh");
      return static_cast<Index>(e.count);
    }
    throw FileError(name_, "", "no element 'vertex' in it: give a mesh");
  }

  void read_element(const PlyElement& element) {
    places_ = places_of(element, name_);
    // Before memory is reserved: refuses a count of rows that the rest of the file cannot hold.
    const std::uint64_t least = Source::least_bytes(element);
    if (element.count > source_.bytes_left() / least)
      fail(element, fmt::format("{} rows are announced, but the file has room for {} at most: it was cut short or its "
                                "header is wrong, write or copy it again",
                                element.count, source_.bytes_left() / least));
    const ElementKind kind = kind_of(element);
    if (kind == ElementKind::vertex) mesh_.positions.reserve(element.count);
    if (kind == ElementKind::face) mesh_.faces.reserve(element.count);
    for (std::uint64_t row = 0; row < element.count; ++row) read_row(element, kind, row);
    if (kind == ElementKind::other && element.count > 0)
      mesh_.notes.push_back(fmt::format("element {} was skipped", in_quotes(element.name)));
  }

  void read_row(const PlyElement& element, ElementKind kind, std::uint64_t row) {
    source_.begin_row(element.name, row);
    for (std::size_t i = 0; i < element.properties.size(); ++i) read_property(element.properties[i], places_[i]);
    source_.end_row();
    if (kind == ElementKind::vertex) add_vertex();
    if (kind == ElementKind::face) add_face();
    if (kind == ElementKind::point) mesh_.loose_points.push_back(index(values_[0]));
    if (kind == ElementKind::edge) mesh_.loose_edges.push_back({index(values_[0]), index(values_[1])});
  }

  void read_property(const PlyProperty& property, int place) {
    if (!property.is_list) {
      const double value = source_.number(property.type);
      if (place != kSkipped) values_[static_cast<std::size_t>(place)] = value;
      return;
    }
    const double length = source_.number(property.count_type);
    if (!(length >= 0) || length != std::floor(length))
      source_.fail("a list cannot have this length: correct the file");
    if (place == kCorners) corners_.clear();
    for (double i = 0; i < length; ++i) {
      const double value = source_.number(property.type);
      if (place == kCorners) corners_.push_back(index(value));
    }
  }

  void add_vertex() {
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (!std::isfinite(values_[axis]))
        source_.fail(fmt::format("coordinate {} is not finite: give finite coordinates", "xyz"[axis]));
    mesh_.positions.push_back(values_);
  }

  void add_face() {
    if (corners_.size() < 3) source_.fail(fmt::format("it has {} corners: give a face three or more", corners_.size()));
    polygons_.add(corners_, mesh_);
  }

  Index index(double value) const {
    if (value >= 0 && value < vertex_count_ && value == std::floor(value)) return static_cast<Index>(value);
    source_.fail(fmt::format("{} is no vertex index, these are 0 to {}: correct the file", value, vertex_count_ - 1));
  }

  [[noreturn]] void fail(const PlyElement& element, const std::string& what) const {
    throw FileError(name_, fmt::format("line {}, element {}", element.line, in_quotes(element.name)), what);
  }

  const PlyHeader& header_;
  std::string_view bytes_;
  const std::string& name_;
  Source source_;
  Index vertex_count_ = 0;
  std::vector<int> places_;
  Point values_{};
  std::vector<Index> corners_;
  Polygons polygons_;
  MeshFile mesh_;
};

}  // namespace

bool looks_like_ply(std::string_view bytes) { return bytes.starts_with("ply\n") || bytes.starts_with("ply\r"); }

MeshFile parse_ply(std::string_view bytes, const std::string& name) {
  const PlyHeader header = parse_ply_header(bytes, name);
  switch (header.encoding) {
    case PlyEncoding::ascii:
      return BodyReader<AsciiSource>(header, bytes, name).read();
    case PlyEncoding::little_endian:
      return BodyReader<BinarySource<std::endian::little>>(header, bytes, name).read();
    case PlyEncoding::big_endian:
      return BodyReader<BinarySource<std::endian::big>>(header, bytes, name).read();
  }
  throw FileError(name, "", "unknown encoding");
}

}  // namespace tamis::io
