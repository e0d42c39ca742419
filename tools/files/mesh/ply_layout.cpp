#include "files/mesh/ply_layout.hpp"

#include <algorithm>

#include "files/error.hpp"

namespace tamis::io {
namespace {

/// Place of a property by its name.
int place_of(ElementKind element, const PlyProperty& p) {
  if (p.is_list) {
    const bool is_corners = p.name == "vertex_indices" || p.name == "vertex_index";
    const bool has_corners = element == ElementKind::face || element == ElementKind::strip;
    return has_corners && is_corners ? kCorners : kSkipped;
  }
  if (element == ElementKind::vertex && (p.name == "x" || p.name == "y" || p.name == "z")) return p.name[0] - 'x';
  if (element == ElementKind::point && p.name == "vertex") return 0;
  if (element == ElementKind::edge && (p.name == "vertex1" || p.name == "vertex2")) return p.name[6] - '1';
  return kSkipped;
}

/// Throws FileError unless the element has, exactly once, each property without which it means nothing.
void require_places(const PlyElement& element, const std::vector<int>& places, const std::string& name) {
  const auto require = [&](int place, const std::string& what) {
    const auto n = std::count(places.begin(), places.end(), place);
    if (n == 1) return;
    throw FileError(name, fmt::format("line {}", element.line),
                    fmt::format("element '{}' has {} {}: give it exactly one", element.name,
                                n == 0 ? "no" : "more than one", what));
  };
  if (element.name == "vertex")
    for (const char* coordinate : {"x", "y", "z"}) require(*coordinate - 'x', fmt::format("property {}", coordinate));
  if (kind_of(element) == ElementKind::point) require(0, "property vertex");
  if (element.name == "face" || element.name == "tristrips") require(kCorners, "list property vertex_indices");
  if (element.name == "edge")
    for (const char digit : {'1', '2'}) require(digit - '1', fmt::format("property vertex{}", digit));
}

}  // namespace

ElementKind kind_of(const PlyElement& element) {
  if (element.name == "vertex") return ElementKind::vertex;
  if (element.name == "face") return ElementKind::face;
  if (element.name == "tristrips") return ElementKind::strip;
  if (element.name == "edge") return ElementKind::edge;
  // Other programs may call something else a point.
  const auto is_vertex = [](const PlyProperty& p) { return !p.is_list && p.name == "vertex"; };
  if (element.name == "point" && std::any_of(element.properties.begin(), element.properties.end(), is_vertex))
    return ElementKind::point;
  return ElementKind::other;
}

std::vector<int> places_of(const PlyElement& element, const std::string& name) {
  std::vector<int> places;
  for (const PlyProperty& p : element.properties) places.push_back(place_of(kind_of(element), p));
  require_places(element, places, name);
  return places;
}

}  // namespace tamis::io
