// The body of a PLY file, element by element, as its header announces it.
#include <algorithm>
#include <cmath>
#include <limits>

#include "files/mesh/mesh_builder.hpp"
#include "files/mesh/ply.hpp"
#include "files/mesh/ply_layout.hpp"
#include "files/mesh/ply_source.hpp"

namespace tamis::io {
namespace {

constexpr Index kEndOfStrip = -1;
constexpr double kEndAsUnsigned = 4294967295;  ///< the same in a list of unsigned numbers

template <class Source>
class BodyReader {
 public:
  BodyReader(const PlyHeader& header, std::string_view bytes, const std::string& name)
      : header_(header), bytes_(bytes), name_(name), source_(bytes.substr(header.bytes), header, name), mesh_(name) {}

  MeshFile read() {
    vertex_count_ = count_vertices();
    for (const PlyElement& element : header_.elements) read_element(element);
    source_.end();
    if (header_.encoding == PlyEncoding::ascii) note_open_end(bytes_, mesh_);
    return mesh_.finish();
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
    if (kind == ElementKind::vertex) begin_vertices(element);
    for (std::uint64_t row = 0; row < element.count; ++row) read_row(element, kind, row);
    if (kind == ElementKind::other && element.count > 0)
      mesh_.add_note(fmt::format("element {} was skipped", in_quotes(element.name)));
  }

  void begin_vertices(const PlyElement& vertex) {
    mesh_.reserve_vertices(static_cast<std::size_t>(vertex.count));
    for (std::size_t i = 0; i < places_.size(); ++i)
      if (places_[i] != kSkipped && vertex.properties[i].type == PlyScalar::float32) mesh_.set_floats();
  }

  void read_row(const PlyElement& element, ElementKind kind, std::uint64_t row) {
    source_.begin_row(element.name, row);
    for (std::size_t i = 0; i < element.properties.size(); ++i) read_property(element.properties[i], kind, places_[i]);
    source_.end_row();
    if (kind == ElementKind::vertex) mesh_.add_vertex(values_, [&] { return source_.place(); });
    if (kind == ElementKind::face) add_face();
    if (kind == ElementKind::strip) add_strip();
    if (kind == ElementKind::point) mesh_.add_loose_point(index(values_[0]));
    if (kind == ElementKind::edge) mesh_.add_loose_edge({index(values_[0]), index(values_[1])});
  }

  void read_property(const PlyProperty& property, ElementKind kind, int place) {
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
      if (place != kCorners) continue;
      const bool ends_strip = kind == ElementKind::strip && (value == kEndOfStrip || value == kEndAsUnsigned);
      corners_.push_back(ends_strip ? kEndOfStrip : index(value));
    }
  }

  void add_face() {
    if (corners_.size() < 3) source_.fail(fmt::format("it has {} corners: give a face three or more", corners_.size()));
    mesh_.add_polygon(corners_);
  }

  /// Strips of triangles; -1 ends each. Every second triangle is listed in the other winding, and turned back here.
  void add_strip() {
    std::size_t first = 0;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      if (corners_[i] == kEndOfStrip) first = i + 1;
      if (i < first + 2) continue;
      const std::size_t odd = (i - first) % 2;
      const Face f{corners_[i - 2], corners_[i - 1 + odd], corners_[i - odd]};
      // A corner listed twice leads from one part of a strip to the next.
      if (f[0] != f[1] && f[1] != f[2] && f[2] != f[0]) mesh_.add_polygon(f);
    }
  }

  Index index(double value) const {
    if (value >= 0 && value < vertex_count_ && value == std::floor(value)) return static_cast<Index>(value);
    source_.fail(
        fmt::format("{} is not a vertex index, these are 0 to {}: correct the file", value, vertex_count_ - 1));
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
  MeshBuilder mesh_;
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
