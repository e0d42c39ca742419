#include "command/step_files.hpp"

#include <fmt/format.h>

#include "audit/doubts.hpp"
#include "command/command_line/messages.hpp"
#include "command/report.hpp"
#include "files/mesh/weld.hpp"
#include "files/scale_step.hpp"

namespace tamis::cli {

io::MeshFile read_with_notes(const std::filesystem::path& path) {
  io::MeshFile mesh = io::read_mesh(path);
  for (const std::string& note : mesh.notes) cli::note(fmt::format("{}: {}", path.string(), note));
  return mesh;
}

void weld(io::MeshFile& first, std::span<const std::vector<Point>> others, std::optional<double> distance) {
  if (!distance) return;
  io::Weld weld(first.positions.size(), *distance);
  weld.add_frame(first.positions);
  const std::size_t at_first = weld.joined_count();
  for (const std::vector<Point>& positions : others) weld.add_frame(positions);
  const std::size_t joined = weld.joined_count();
  weld.apply_to(first);
  note_weld(joined, at_first);
}

void note_weld(std::size_t joined, std::size_t joined_at_first) {
  std::string sentence = fmt::format("--weld joined {} to others", counted(joined, "vertex", "vertices"));
  if (joined < joined_at_first)
    sentence += fmt::format("; {} more part in a later frame, and stay apart", joined_at_first - joined);
  note(sentence);
}

void note_coincident(const Mesh& mesh, const Positions& positions) {
  if (const std::string doubt = audit::doubt_about_coincidence(mesh, positions); !doubt.empty()) note(doubt);
}

void note_units(const std::string& end_name, const Positions& start, const Positions& end) {
  if (const std::string doubt = audit::doubt_about_units(start, end); !doubt.empty())
    note(fmt::format("{}: {}", end_name, doubt));
}

std::vector<Point> between(const std::vector<Point>& start, const std::vector<Point>& end, double part) {
  std::vector<Point> points = start;
  for (std::size_t v = 0; v < points.size(); ++v)
    for (std::size_t axis = 0; axis < 3; ++axis) points[v][axis] = io::part_of_way(start[v][axis], end[v][axis], part);
  return points;
}

StepFiles read_step(const std::filesystem::path& start, const std::filesystem::path& end, double scale,
                    std::optional<double> weld_distance) {
  io::MeshFile first = read_with_notes(start);
  io::MeshFile second = io::read_mesh(end);
  for (const std::string& sentence : second.notes_of_later_frame()) note(fmt::format("{}: {}", end.string(), sentence));
  io::require_same_mesh(first, start.string(), second, end.string());
  weld(first, std::span(&second.positions, 1), weld_distance);
  std::vector<Point> positions = first.positions;
  const std::string doubt = audit::doubt_about_units(positions, second.positions);
  io::scale_step(positions, second.positions, scale);
  if (!doubt.empty()) note(fmt::format("{}: {}", end.string(), doubt));
  std::vector<Edge> loose_edges = first.loose_edges;
  std::vector<Index> loose_points = first.loose_points;
  return {io::mesh_of(std::move(first)), std::move(positions), std::move(second.positions), std::move(loose_edges),
          std::move(loose_points)};
}

}  // namespace tamis::cli
