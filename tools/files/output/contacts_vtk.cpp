#include "files/output/contacts_vtk.hpp"

#include <fmt/format.h>

#include "files/atomic_file.hpp"
#include "files/output/contact_geometry.hpp"
#include "numbers/floating_point_state.hpp"

namespace tamis::io {
namespace {

class Document {
 public:
  Document(const std::filesystem::path& path, const char* type) : file_(path), type_(type) {
    add("<?xml version=\"1.0\"?>\n<VTKFile type=\"{0}\" version=\"1.0\" byte_order=\"LittleEndian\">\n<{0}>\n", type);
  }

  template <class... Parts>
  void add(fmt::format_string<Parts...> format, Parts&&... parts) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Parts>(parts)...);
    // Writes the text in chunks of this size: a step may have millions of contacts.
    constexpr std::size_t kChunk = std::size_t{1} << 16;
    if (text_.size() > kChunk) flush();
  }

  /// `write` adds the row of one contact.
  template <class Write>
  void add_array(const char* type, const char* name, int components, std::size_t rows, const Write& write) {
    add("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"ascii\">\n", type, name, components);
    for (std::size_t row = 0; row < rows; ++row) write(row);
    add("</DataArray>\n");
  }

  void finish() {
    add("</Piece>\n</{}>\n</VTKFile>\n", type_);
    flush();
    file_.commit();
  }

 private:
  void flush() {
    file_.append({text_.data(), text_.size()});
    text_.clear();
  }

  AtomicFile file_;
  const char* type_;
  fmt::memory_buffer text_;
};

void add_data(Document& document, std::span<const Contact> contacts) {
  document.add("<PointData Normals=\"normal\" Scalars=\"toi_lower\">\n");
  const auto add = [&](const char* type, const char* name, int components, const auto& row) {
    document.add_array(type, name, components, contacts.size(), [&](std::size_t i) { row(contacts[i]); });
  };
  add("Float64", "normal", 3,
      [&](const Contact& c) { document.add("{} {} {}\n", c.normal[0], c.normal[1], c.normal[2]); });
  add("Int32", "vertices", 4, [&](const Contact& c) {
    document.add("{} {} {} {}\n", c.vertices[0], c.vertices[1], c.vertices[2], c.vertices[3]);
  });
  add("Int8", "kind", 1, [&](const Contact& c) { document.add("{}\n", static_cast<int>(c.kind)); });
  add("Int8", "status", 1, [&](const Contact& c) { document.add("{}\n", static_cast<int>(c.certainty)); });
  add("Float64", "toi_lower", 1, [&](const Contact& c) { document.add("{}\n", c.toi_lower); });
  add("Float64", "toi_upper", 1, [&](const Contact& c) { document.add("{}\n", c.toi_upper); });
  add("Float64", "weights", 2, [&](const Contact& c) { document.add("{} {}\n", c.u, c.v); });
  document.add("</PointData>\n");
}

void add_points(Document& document, std::span<const Contact> contacts, std::span<const Point> start,
                std::span<const Point> end) {
  document.add("<Points>\n");
  document.add_array("Float64", "points", 3, contacts.size(), [&](std::size_t i) {
    const Point point = contact_point(contacts[i], start, end, contacts[i].toi_upper);
    document.add("{} {} {}\n", point[0], point[1], point[2]);
  });
  document.add("</Points>\n");
}

/// Every point is a cell of its own.
void add_cells(Document& document, std::size_t count) {
  document.add_array("Int64", "connectivity", 1, count, [&](std::size_t i) { document.add("{}\n", i); });
  document.add_array("Int64", "offsets", 1, count, [&](std::size_t i) { document.add("{}\n", i + 1); });
}

}  // namespace

void write_contacts_vtp(const std::filesystem::path& path, std::span<const Contact> contacts,
                        std::span<const Point> start, std::span<const Point> end) {
  const ComputingState state;
  Document document(path, "PolyData");
  document.add("<Piece NumberOfPoints=\"{0}\" NumberOfVerts=\"{0}\">\n", contacts.size());
  add_data(document, contacts);
  add_points(document, contacts, start, end);
  document.add("<Verts>\n");
  add_cells(document, contacts.size());
  document.add("</Verts>\n");
  document.finish();
}

void write_contacts_vtu(const std::filesystem::path& path, std::span<const Contact> contacts,
                        std::span<const Point> start, std::span<const Point> end) {
  const ComputingState state;
  constexpr int kVertexCell = 1;  // as VTK numbers it
  Document document(path, "UnstructuredGrid");
  document.add("<Piece NumberOfPoints=\"{0}\" NumberOfCells=\"{0}\">\n", contacts.size());
  add_data(document, contacts);
  add_points(document, contacts, start, end);
  document.add("<Cells>\n");
  add_cells(document, contacts.size());
  document.add_array("UInt8", "types", 1, contacts.size(), [&](std::size_t) { document.add("{}\n", kVertexCell); });
  document.add("</Cells>\n");
  document.finish();
}

}  // namespace tamis::io
