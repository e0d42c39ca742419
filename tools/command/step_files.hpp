// Two frames of one mesh as a step.
#pragma once
#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "files/mesh/mesh_file.hpp"
#include "tamis/error.hpp"
#include "tamis/mesh.hpp"
#include "tamis/step.hpp"

namespace tamis::cli {

/// Reads a mesh and prints its notes on stderr.
io::MeshFile read_with_notes(const std::filesystem::path& path);

/// Joins vertices of `first` that lie within `distance` of each other in it and in all `others`, and notes on stderr
/// how many. Does nothing without a distance.
void weld(io::MeshFile& first, std::span<const std::vector<Point>> others, std::optional<double> distance);

/// Notes on stderr how many vertices were joined, and how many lie together in the first frame alone.
void note_weld(std::size_t joined, std::size_t joined_at_first);

/// Notes on stderr that the two ends of a step seem to have different units.
void note_units(const std::string& end_name, const Positions& start, const Positions& end);

/// Notes on stderr what explains contacts at the start: vertices that lie on each other.
void note_coincident(const Mesh& mesh, const Positions& positions);

/// Positions at `part` of the way from start to end: start for 0; end, but for rounding, for 1.
std::vector<Point> between(const std::vector<Point>& start, const std::vector<Point>& end, double part);

/// Returns ask(), the answer about `step`. If the step is refused, the sentence names it.
template <class Ask>
auto asked_of(const std::string& step, const Ask& ask) {
  try {
    return ask();
  } catch (const InvalidStep& error) {
    throw InvalidStep(fmt::format("{}: {}", step, error.what()));
  }
}

struct StepFiles {
  Mesh mesh;
  std::vector<Point> start;
  std::vector<Point> end;
  std::vector<Edge> loose_edges;    ///< as the files list them
  std::vector<Index> loose_points;  ///< the same

  /// Valid as long as this object.
  Step step() const { return {start, end}; }
};

/// Throws io::FileError if a file cannot be used or the two are not frames of one mesh.
StepFiles read_step(const std::filesystem::path& start, const std::filesystem::path& end, double scale,
                    std::optional<double> weld_distance = {});

}  // namespace tamis::cli
