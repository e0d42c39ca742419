#include "paths/mesh_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "numerics/number_text.hpp"
#include "paths/path_reader.hpp"
#include "tamis/error.hpp"
#include "topology/at.hpp"
#include "topology/mean_edge.hpp"

namespace tamis {
namespace {

constexpr double kShortestPiece = 0x1p-20;

std::vector<Index> numbers_of(const Mesh& mesh, const Path& path) {
  if (path.vertex_count() != mesh.vertex_count())
    throw InvalidPath("the path has " + std::to_string(path.vertex_count()) + " vertices, the mesh " +
                      std::to_string(mesh.vertex_count()) + ": give a path of this mesh");
  std::vector<Index> all(at(mesh.vertex_count()));
  std::iota(all.begin(), all.end(), 0);
  return all;
}

}  // namespace

MeshPieces::MeshPieces(const Mesh& mesh, const Path& path, std::span<const double> ends)
    : mesh_(mesh), path_(path), ends_(ends), all_(numbers_of(mesh, path_)), deviations_(all_.size()) {}

Frame MeshPieces::next(const Frame& from) {
  Frame to = frame_at(end_of(from));
  read_deviations(from.time, to.time);
  check_chords(from, to);
  return to;
}

Frame MeshPieces::frame_at(double time) const {
  Frame frame{time, std::vector<Point>(all_.size()), std::vector<double>(all_.size())};
  path_.points_at(time, all_, frame.points, frame.errors);
  for (const Index v : mesh_.points()) check_point(v, time, frame.points[at(v)], frame.errors[at(v)]);
  return frame;
}

double MeshPieces::read_deviations(double from, double to) {
  path_.deviations(from, to, all_, deviations_);
  double largest = 0;
  for (const Index v : mesh_.points()) {
    check_deviation(v, from, to, deviations_[at(v)]);
    largest = std::max(largest, deviations_[at(v)]);
  }
  return largest;
}

double MeshPieces::end_of(const Frame& start) {
  if (!ends_.empty()) return *std::ranges::upper_bound(ends_, start.time);
  const double allowed = deviation_in_edges_ * mean_edge(mesh_, start.points);
  double length = 1 - start.time;
  for (; length > kShortestPiece; length *= kNearMiddle) {
    const double largest = read_deviations(start.time, start.time + length);
    if (largest <= allowed || !(allowed > 0)) break;
  }
  return length < 1 - start.time ? start.time + length : 1;
}

void MeshPieces::learn(std::size_t pairs) {
  constexpr std::size_t kFewOfVertices = 32, kManyOfVertices = 8;  // so manieth parts of them
  constexpr double kFactor = 4;                                    // a piece twice as long
  const std::size_t vertices = mesh_.points().size();
  if (kFewOfVertices * pairs <= vertices)
    deviation_in_edges_ = std::min(kFactor * deviation_in_edges_, kMostChordDeviationInEdges);
  else if (kManyOfVertices * pairs > vertices)
    deviation_in_edges_ = std::max(deviation_in_edges_ / kFactor, kChordDeviationInEdges);
}

double MeshPieces::farthest_way() {
  const Frame from = frame_at(0), to = frame_at(1);
  read_deviations(0, 1);
  double farthest = 0;
  for (const Index index : mesh_.points()) {
    const std::size_t v = at(index);
    Point way{};
    for (std::size_t k = 0; k < 3; ++k)
      way[k] = std::fabs(to.points[v][k] - from.points[v][k]) + from.errors[v] + to.errors[v];
    farthest = std::max(farthest, std::hypot(way[0], way[1], way[2]) + deviations_[v]);
  }
  return farthest;
}

void MeshPieces::check_chords(const Frame& from, const Frame& to) const {
  const Frame middle = frame_at(0.5 * from.time + 0.5 * to.time);
  for (const Index index : mesh_.points()) {
    const std::size_t v = at(index);
    Point off{};
    double size = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      off[k] = middle.points[v][k] - (0.5 * from.points[v][k] + 0.5 * to.points[v][k]);
      size = std::max(size, std::fabs(middle.points[v][k]));
    }
    const double distance = std::hypot(off[0], off[1], off[2]), bound = deviations_[v];
    const double errors = 2 * (middle.errors[v] + from.errors[v] + to.errors[v]) + 0x1p-48 * size;
    if (distance <= bound + errors) continue;
    throw InvalidPath("vertex " + std::to_string(index) + " of the path is " + number_text(distance) +
                      " from its chord at t = " + number_text(middle.time) + ", beyond its bound " +
                      number_text(bound) + ": give a bound that holds");
  }
}

}  // namespace tamis
