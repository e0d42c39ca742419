#include "files/output/glb.hpp"

#include <limits>

#include "files/atomic_file.hpp"
#include "files/error.hpp"
#include "files/extent.hpp"
#include "files/mesh/loose_features.hpp"
#include "files/output/colours.hpp"
#include "files/output/contact_geometry.hpp"
#include "files/output/glb_scene.hpp"
#include "numbers/floating_point_state.hpp"

namespace tamis::io {
namespace {

/// In units of the mesh: a float has all its digits down to 2^-24 of it.
constexpr double kLeastExtent = std::numeric_limits<float>::min() * double(1 << 24);

template <class Row>
std::vector<Index> flat(std::span<const Row> rows) {
  std::vector<Index> indices;
  for (const Row& row : rows) indices.insert(indices.end(), row.begin(), row.end());
  return indices;
}

void add_mesh(GlbScene& scene, const Mesh& mesh, const Extent& extent, std::span<const Point> start,
              std::span<const Point> end) {
  // Unused vertices may be anywhere: puts them in the middle.
  MovingPoints points{std::vector<Point>(start.size(), extent.middle), std::vector<Point>(end.size(), extent.middle)};
  for (const Index index : mesh.points()) {
    const auto v = static_cast<std::size_t>(index);
    points.start[v] = start[v];
    points.end[v] = end[v];
  }
  const Json motion = scene.add_motion(points);
  Json primitives = Json::array();
  scene.add_indexed(primitives, motion, GlbMode::triangles, flat<Face>(mesh.faces()));
  scene.add_indexed(primitives, motion, GlbMode::lines, flat<Edge>(rods_of(mesh)));
  scene.add_indexed(primitives, motion, GlbMode::points, loose_points_of(mesh));
  scene.add_node("mesh", std::move(primitives), Json());
}

/// Columns as in the CSV file; rows in the order of the points.
Json table(std::span<const Contact> contacts) {
  Json rows = Json::array();
  for (const Contact& c : contacts)
    rows.push_back({name_of(c.kind), c.vertices[0], c.vertices[1], c.vertices[2], c.vertices[3], c.toi_lower,
                    c.toi_upper, c.u, c.v, c.certainty == Certainty::certified ? "certified" : "unresolved"});
  return {{"columns", {"kind", "v0", "v1", "v2", "v3", "toi_lower", "toi_upper", "u", "v", "status"}},
          {"rows", std::move(rows)}};
}

void add_contacts(GlbScene& scene, const Extent& extent, std::span<const Point> start, std::span<const Point> end,
                  std::span<const Contact> contacts) {
  constexpr double kArrow = 0.02;  // in units of half the scene
  MovingPoints places, arrows;
  std::vector<Colour> colours, arrow_colours;
  for (const Contact& c : contacts) {
    const auto [red, green, blue] = colour_of_time(c.toi_lower);
    colours.push_back({red, green, blue, 255});
    arrow_colours.insert(arrow_colours.end(), 2, colours.back());
    for (const auto& [time, place, arrow] :
         {std::tuple{0.0, &places.start, &arrows.start}, std::tuple{1.0, &places.end, &arrows.end}}) {
      Point point = contact_point(c, start, end, time);
      place->push_back(point);
      arrow->push_back(point);
      for (std::size_t axis = 0; axis < 3; ++axis) point[axis] += kArrow * extent.half * c.normal[axis];
      arrow->push_back(point);
    }
  }
  Json primitives = Json::array();
  scene.add_coloured(primitives, scene.add_motion(places), GlbMode::points, colours);
  scene.add_coloured(primitives, scene.add_motion(arrows), GlbMode::lines, arrow_colours);
  scene.add_node("contacts", std::move(primitives), table(contacts));
}

}  // namespace

void write_glb(const std::filesystem::path& path, const Mesh& mesh, std::span<const Point> start,
               std::span<const Point> end, std::span<const Contact> contacts) {
  const ComputingState state;
  const Extent extent = extent_of(mesh, start, end);
  // Displacements, and their sums with positions in readers, must not overflow floats either.
  if (!(extent.half < std::numeric_limits<float>::max() / 4))
    throw FileError(path.string(), "",
                    "the mesh is too large for the floats of glTF: scale it down, or write html, csv or vtp");
  // Below, a float has fewer digits, and in the end none: the motion would be another, or nothing.
  if (extent.half > 0 && extent.half < kLeastExtent)
    throw FileError(path.string(), "",
                    "the mesh is too small for the floats of glTF: scale it up, or write html, csv or vtp");
  GlbScene scene(extent.middle);
  add_mesh(scene, mesh, extent, start, end);
  if (!contacts.empty()) add_contacts(scene, extent, start, end, contacts);
  AtomicFile file(path);
  file.append(scene.file());
  file.commit();
}

}  // namespace tamis::io
