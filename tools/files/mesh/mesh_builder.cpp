#include "files/mesh/mesh_builder.hpp"

#include <algorithm>
#include <cmath>

#include "files/error.hpp"
#include "files/mesh/coordinate_spacing.hpp"
#include "files/mesh/polygons.hpp"

namespace tamis::io {

bool MeshBuilder::is_finite(const Point& p) {
  return std::ranges::all_of(p, [](double x) { return std::isfinite(x); });
}

void MeshBuilder::add_polygon(std::span<const Index> corners) {
  mesh_.corner_counts.push_back(static_cast<Index>(corners.size()));
  mesh_.corners.insert(mesh_.corners.end(), corners.begin(), corners.end());
}

MeshFile MeshBuilder::finish() {
  require_finite();
  Polygons polygons;
  mesh_.faces.reserve(mesh_.corner_counts.size());
  polygons.cut_all(mesh_.corner_counts, mesh_.corners, mesh_.positions, mesh_.faces);
  const std::size_t notes = mesh_.notes.size();
  for (std::string& note : polygons.notes()) add_note(std::move(note));
  if (!polygons.are_any_cut()) {
    mesh_.corner_counts = {};
    mesh_.corners = {};
  }
  if (std::string note = note_on_spacing(mesh_); !note.empty()) add_note(std::move(note));
  mesh_.surface_notes = mesh_.notes.size() - notes;
  return std::move(mesh_);
}

void MeshBuilder::require_finite() const {
  if (not_finite_.empty()) return;
  std::vector<bool> is_used(vertex_count());
  const auto use = [&](Index v) { is_used[static_cast<std::size_t>(v)] = true; };
  std::ranges::for_each(mesh_.corners, use);
  for (const Edge& edge : mesh_.loose_edges) std::ranges::for_each(edge, use);
  std::ranges::for_each(mesh_.loose_points, use);
  for (const auto& [vertex, where] : not_finite_)
    if (is_used[vertex]) {
      const Point& p = mesh_.positions[vertex];
      const auto axis = std::ranges::find_if(p, [](double x) { return !std::isfinite(x); }) - p.begin();
      throw FileError(name_, where, fmt::format("coordinate {} is not finite: give finite coordinates", "xyz"[axis]));
    }
}

void note_open_end(std::string_view text, MeshBuilder& mesh) {
  if (!text.ends_with('\n') && !text.ends_with('\r'))
    mesh.add_note("the last line has no line end: was the file cut short?");
}

}  // namespace tamis::io
