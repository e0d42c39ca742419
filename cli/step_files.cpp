#include "cli/step_files.hpp"

#include <fmt/format.h>

#include "cli/command_line/messages.hpp"
#include "io/scale_step.hpp"

namespace tamis::cli {

io::MeshFile read_with_notes(const std::filesystem::path& path) {
  io::MeshFile mesh = io::read_mesh(path);
  for (const std::string& note : mesh.notes) cli::note(fmt::format("{}: {}", path.string(), note));
  return mesh;
}

std::vector<Point> between(const std::vector<Point>& start, const std::vector<Point>& end, double part) {
  std::vector<Point> points = start;
  for (std::size_t v = 0; v < points.size(); ++v)
    for (std::size_t axis = 0; axis < 3; ++axis) points[v][axis] = io::part_of_way(start[v][axis], end[v][axis], part);
  return points;
}

StepFiles read_step(const std::string& start, const std::string& end, double scale) {
  io::MeshFile first = read_with_notes(start);
  io::MeshFile second = read_with_notes(end);
  io::require_same_mesh(first, start, second, end);
  io::scale_step(first.positions, second.positions, scale);
  std::vector<Point> positions = first.positions;
  return {io::mesh_of(std::move(first)), std::move(positions), std::move(second.positions),
          std::move(second.loose_edges), std::move(second.loose_points)};
}

}  // namespace tamis::cli
