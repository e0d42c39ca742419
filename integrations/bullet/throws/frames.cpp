#include "integrations/bullet/throws/frames.hpp"

#include <fmt/core.h>

#include "files/mesh/ply.hpp"
#include "integrations/bullet/mesh_of_shape.hpp"

namespace tamis::bullet {

void write_frames(const std::filesystem::path& folder, const std::string& name,
                  std::span<const std::vector<Point>> frames, std::span<const Face> faces) {
  std::filesystem::create_directories(folder);
  io::MeshFile file{{}, {faces.begin(), faces.end()}, {}, {}, {}};
  for (std::size_t i = 0; i < frames.size(); ++i) {
    file.positions = frames[i];
    io::write_ply(folder / fmt::format("{}_{:04}.ply", name, i), file);
  }
}

void write_frames(const std::filesystem::path& folder, const std::string& name, std::span<const Triangles> bodies,
                  const Places& places, std::size_t first) {
  std::vector<std::vector<Point>> frames(places.size());
  std::vector<Face> faces;
  for (std::size_t body = first; body < bodies.size(); ++body) {
    const auto before = static_cast<Index>(frames[0].size());
    for (const Face& face : bodies[body].faces) faces.push_back({face[0] + before, face[1] + before, face[2] + before});
    for (std::size_t i = 0; i < frames.size(); ++i)
      for (const Point& p : bodies[body].points) frames[i].push_back(point_of(places[i][body] * vector_of(p)));
  }
  write_frames(folder, name, frames, faces);
}

}  // namespace tamis::bullet
