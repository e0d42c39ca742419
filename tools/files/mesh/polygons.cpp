#include "files/mesh/polygons.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace tamis::io {

void Polygons::cut_all(std::span<const Index> counts, std::span<const Index> corners, std::span<const Point> positions,
                       std::vector<Face>& faces) {
  for (const Index count : counts) {
    const auto size = static_cast<std::size_t>(count);
    if (size >= 3) cut(corners.first(size), positions, faces);
    corners = corners.subspan(size);
  }
}

void Polygons::cut(std::span<const Index> corners, std::span<const Point> positions, std::vector<Face>& faces) {
  const PolygonDoubts doubts = triangulation_.cut(corners, positions, faces);
  if (corners.size() > 3) ++cut_;
  if (doubts.is_bent) bent_.add(corners);
  if (doubts.is_tangled) tangled_.add(corners);
}

std::vector<std::string> Polygons::notes() const {
  std::vector<std::string> notes = doubts();
  if (cut_ > 0)
    notes.insert(notes.begin(),
                 cut_ == 1 ? "1 polygon of more than three corners was cut into triangles"
                           : fmt::format("{} polygons of more than three corners were cut into triangles", cut_));
  return notes;
}

std::vector<std::string> Polygons::doubts() const {
  std::vector<std::string> notes;
  if (bent_.count > 0)
    notes.push_back(bent_.text("polygon is not flat", "polygons are not flat") +
                    ": other programs may cut them into other surfaces");
  if (tangled_.count > 0)
    notes.push_back(
        tangled_.text("polygon crosses itself or has no area", "polygons cross themselves or have no area") +
        ": their triangles may overlap, correct them");
  return notes;
}

void Polygons::Count::add(std::span<const Index> corners) {
  constexpr std::size_t kShown = 8;
  if (count++ > 0) return;
  first = fmt::format("{}{}", fmt::join(corners.first(std::min(corners.size(), kShown)), ", "),
                      corners.size() > kShown ? ", ..." : "");
}

std::string Polygons::Count::text(const char* one, const char* many) const {
  return fmt::format("{} {}, the first joins vertices {}", count, count == 1 ? one : many, first);
}

}  // namespace tamis::io
