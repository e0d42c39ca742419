// Two frames of one mesh as a step.
#pragma once
#include <fmt/format.h>

#include <filesystem>
#include <string>
#include <vector>

#include "io/mesh/mesh_file.hpp"
#include "tamis/error.hpp"
#include "tamis/mesh.hpp"
#include "tamis/step.hpp"

namespace tamis::cli {

/// Reads a mesh and prints its notes on stderr.
io::MeshFile read_with_notes(const std::filesystem::path& path);

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
StepFiles read_step(const std::string& start, const std::string& end, double scale);

}  // namespace tamis::cli
