// Collects what a mesh file holds, the same way for every format, and makes a mesh of it.
#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "files/error.hpp"
#include "files/mesh/mesh_file.hpp"
#include "files/text.hpp"

namespace tamis::io {

class MeshBuilder {
 public:
  /// `name` stands for the file in messages. Keeps a reference.
  explicit MeshBuilder(const std::string& name) : name_(name) {}

  /// `where` returns the place in the file as text; it is called for points that are not finite.
  template <class Where>
  void add_vertex(const Point& p, const Where& where) {
    if (!is_finite(p)) not_finite_.emplace_back(mesh_.positions.size(), where());
    mesh_.positions.push_back(p);
  }
  /// REQUIRES: three corners or more.
  void add_polygon(std::span<const Index> corners);
  void add_loose_edge(const Edge& edge) { mesh_.loose_edges.push_back(edge); }
  void add_loose_point(Index v) { mesh_.loose_points.push_back(v); }
  void add_note(std::string note) { mesh_.notes.push_back(std::move(note)); }
  /// Are the coordinates stored in single precision?
  void set_floats() { mesh_.are_floats = true; }
  void reserve_vertices(std::size_t count) { mesh_.positions.reserve(count); }

  std::size_t vertex_count() const { return mesh_.positions.size(); }
  /// The mesh, with polygons cut into triangles and notes on them. Throws FileError if a vertex that something uses is
  /// not finite. REQUIRES: each index is that of a vertex.
  MeshFile finish();

 private:
  static bool is_finite(const Point& p);
  void require_finite() const;

  const std::string& name_;
  MeshFile mesh_;
  std::vector<std::pair<std::size_t, std::string>> not_finite_;  ///< vertices, and where the file has them
};

/// Takes three numbers off the front of `rest`; `refuse` throws what is said of a word that is not a number.
template <class Refuse>
Point take_point(std::string_view& rest, const Refuse& refuse) {
  Point p;
  for (double& x : p) {
    const std::string_view word = take_word(rest);
    const auto value = to_double(word);
    if (!value) refuse(fmt::format("{} is not a number: a vertex needs three coordinates", in_quotes(word)));
    x = *value;
  }
  return p;
}

/// Notes a last line without a line end: the text may have been cut inside its last number, and nothing else shows it.
void note_open_end(std::string_view text, MeshBuilder& mesh);

}  // namespace tamis::io
