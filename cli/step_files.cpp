#include "cli/step_files.hpp"

#include <fmt/format.h>

#include <cmath>

#include "cli/messages.hpp"
#include "tamis/error.hpp"

namespace tamis::cli {

io::MeshFile read_with_notes(const std::filesystem::path& path) {
  io::MeshFile mesh = io::read_mesh(path);
  for (const std::string& note : mesh.notes) cli::note(fmt::format("{}: {}", path.string(), note));
  return mesh;
}

void scale_step(const std::vector<Point>& start, std::vector<Point>& end, double scale) {
  if (scale == 1) return;
  for (std::size_t v = 0; v < end.size(); ++v)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double& x = end[v][axis];
      x = start[v][axis] + scale * (x - start[v][axis]);
      if (!std::isfinite(x))
        throw InvalidOptions(
            fmt::format("--scale {} takes vertex {} beyond the largest double: give a smaller one", scale, v));
    }
}

std::vector<Point> between(const std::vector<Point>& start, const std::vector<Point>& end, double part) {
  std::vector<Point> points = start;
  for (std::size_t v = 0; v < points.size(); ++v)
    for (std::size_t axis = 0; axis < 3; ++axis) points[v][axis] += part * (end[v][axis] - start[v][axis]);
  return points;
}

StepFiles read_step(const std::string& start, const std::string& end, double scale) {
  io::MeshFile first = read_with_notes(start);
  io::MeshFile second = read_with_notes(end);
  io::require_same_mesh(first, start, second, end);
  scale_step(first.positions, second.positions, scale);
  std::vector<Point> positions = first.positions;
  return {io::mesh_of(std::move(first)), std::move(positions), std::move(second.positions)};
}

}  // namespace tamis::cli
