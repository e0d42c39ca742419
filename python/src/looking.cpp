#include "python/src/looking.hpp"

#include <algorithm>
#include <limits>
#include <sstream>
#include <tuple>

#include "io/view/outputs.hpp"
#include "python/src/paths/path_positions.hpp"
#include "tamis/error.hpp"

namespace tamis::python {
namespace {

auto key_of(const Contact& c) { return std::tie(c.kind, c.vertices, c.toi_lower, c.toi_upper); }

/// Before the first of all contacts; 1 if there is none.
double free_before(std::span<const Contact> found) {
  double time = 1;
  for (const Contact& c : found) time = std::min(time, c.toi_lower);
  return time;
}

/// REQUIRES: `found` in its fixed order, by kind, then vertices.
bool is_part(std::span<const Contact> part, std::span<const Contact> found) {
  const auto before = [](const Contact& a, const Contact& b) { return key_of(a) < key_of(b); };
  return std::all_of(part.begin(), part.end(),
                     [&](const Contact& c) { return std::binary_search(found.begin(), found.end(), c, before); });
}

std::vector<Point> points_of(const Positions& positions) {
  std::vector<Point> points;
  points.reserve(static_cast<std::size_t>(positions.count()));
  for (Index v = 0; v < positions.count(); ++v) points.push_back({positions[v][0], positions[v][1], positions[v][2]});
  return points;
}

Options with(Options options, const QueryOptions& asked) {
  options.min_separation = asked.min_separation.value_or(options.min_separation);
  return options;
}

/// Of the box of the vertices that the mesh uses, its longest side.
double size_of(const Mesh& mesh, const std::vector<Point>& positions) {
  double size = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
    for (const Index v : mesh.points()) {
      lowest = std::min(lowest, positions[static_cast<std::size_t>(v)][axis]);
      highest = std::max(highest, positions[static_cast<std::size_t>(v)][axis]);
    }
    size = std::max(size, highest - lowest);
  }
  return size;
}

/// Do straight pieces of this number look like the path?
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

/// As short as it can be: "0.25".
std::string text_of(double time) {
  std::ostringstream text;
  text << time;
  return text.str();
}

/// `free_before`: of the path.
io::Recording film_of(const Path& path, const Mesh& mesh, const Options& options, std::span<const Contact> contacts,
                      double free_before) {
  const int pieces = pieces_of(path, mesh);
  io::Recording film{mesh, options, 1, {}, {}, std::vector<io::RecordedStep>(static_cast<std::size_t>(pieces))};
  for (int i = 0; i <= pieces; ++i) {
    const double time = double(i) / pieces;
    film.names.push_back("t = " + text_of(time));
    film.frames.push_back(positions_at(path, time));
  }
  for (Contact c : contacts) {
    const int piece = std::min(static_cast<int>(c.toi_lower * pieces), pieces - 1);
    c.toi_lower = c.toi_lower * pieces - piece;
    c.toi_upper = std::min(1.0, c.toi_upper * pieces - piece);
    film.steps[static_cast<std::size_t>(piece)].contacts.push_back(c);
  }
  // A pair is listed where it meets first. It may touch from then on.
  for (int i = 0; i < pieces; ++i)
    if (free_before * pieces < i + 1)
      film.steps[static_cast<std::size_t>(i)].free_before = std::max(0.0, free_before * pieces - i);
  return film;
}

}  // namespace

void write_step(const std::filesystem::path& to, Detector& detector, const Step& step, const QueryOptions& asked,
                std::span<const Contact> part) {
  const auto& found = detector.contacts(step, asked);
  if (!is_part(part, found))
    throw InvalidStep(
        "the positions have changed since these contacts were found: look at contacts before the next step, or give "
        "the detector arrays that stay as they are");
  const Options options = with(detector.options(), asked);
  io::Recording recording{detector.mesh(),
                          options,
                          1,
                          {"start", "end"},
                          {points_of(step.start), points_of(step.end)},
                          {{{part.begin(), part.end()}, detector.statistics().stages}}};
  if (part.size() < found.size()) recording.steps.front().free_before = free_before(found);
  io::output_for(to, io::outputs()).write(to, recording);
}

void write_path(const std::filesystem::path& to, Detector& detector, const Path& path, const QueryOptions& asked,
                std::span<const Contact> part) {
  const io::Output& output = io::output_for(to, io::outputs());
  if (!output.holds_sequence)
    throw Error(to.string() + " would hold one straight piece, and these contacts are of a path: save html or csv");
  const auto& found = detector.contacts(path, asked);
  if (!is_part(part, found))
    throw InvalidPath("the path has changed since these contacts were found: look at them before it does");
  const Options options = with(detector.options(), asked);
  output.write(to, film_of(path, detector.mesh(), options, part, free_before(found)));
}

}  // namespace tamis::python
