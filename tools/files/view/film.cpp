#include "files/view/film.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "curves/paths/callers_path.hpp"
#include "files/extent.hpp"
#include "files/view/path_positions.hpp"
#include "numbers/floating_point_state.hpp"

namespace tamis::io {
namespace {

/// The longest side of the box around the vertices that the mesh uses.
double size_of(const Mesh& mesh, const std::vector<Point>& positions) {
  Box box;
  box.add(mesh, positions);
  double size = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) size = std::max(size, box.highest[axis] - box.lowest[axis]);
  return size;
}

/// Do `pieces` straight pieces look like the path?
bool looks_straight(const Path& path, const Mesh& mesh, int pieces, double size) {
  constexpr double kSeen = 1.0 / 256;  // of the scene
  const std::vector<Index> vertices(mesh.points().begin(), mesh.points().end());
  std::vector<double> deviations(vertices.size());
  for (int i = 0; i < pieces; ++i) {
    path.deviations(double(i) / pieces, double(i + 1) / pieces, vertices, deviations);
    if (std::any_of(deviations.begin(), deviations.end(), [&](double deviation) { return deviation > kSeen * size; }))
      return false;
  }
  return true;
}

int pieces_of(const Path& path, const Mesh& mesh) {
  constexpr int kMost = 64;  // a power of two: times of a piece are exact
  const double size = size_of(mesh, positions_at(path, 0));
  int pieces = 1;
  while (pieces < kMost && !looks_straight(path, mesh, pieces, size)) pieces *= 2;
  return pieces;
}

}  // namespace

void add_path(Recording& recording, const Path& callers, const FoundOnPath& found, const std::string& step) {
  const ComputingState state;
  const CallersPath path(callers);
  const int pieces = pieces_of(path, recording.mesh);
  const std::size_t first = recording.steps.size();
  for (int i = recording.frames.empty() ? 0 : 1; i <= pieces; ++i) {
    const double time = double(i) / pieces;
    recording.names.push_back(fmt::format("{}t = {:g}", step, time));
    recording.frames.push_back(positions_at(path, time));
  }
  recording.steps.resize(first + static_cast<std::size_t>(pieces));
  for (std::size_t piece = first; piece < recording.steps.size(); ++piece)
    recording.steps[piece].ignored = found.ignored;
  for (Contact c : found.contacts) {
    const int piece = std::min(static_cast<int>(c.toi_lower * pieces), pieces - 1);
    c.toi_lower = c.toi_lower * pieces - piece;
    c.toi_upper = std::min(1.0, c.toi_upper * pieces - piece);
    recording.steps[first + static_cast<std::size_t>(piece)].contacts.push_back(c);
  }
  // A pair is listed only in the piece of its first contact, but may touch in all later pieces: these are not free
  // either.
  for (int i = 0; i < pieces; ++i)
    if (found.free_before * pieces < i + 1)
      recording.steps[first + static_cast<std::size_t>(i)].free_before = std::max(0.0, found.free_before * pieces - i);
}

}  // namespace tamis::io
