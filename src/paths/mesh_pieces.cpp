#include "paths/mesh_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "numerics/error_bounds.hpp"
#include "numerics/length.hpp"
#include "numerics/number_text.hpp"
#include "paths/path_reader.hpp"
#include "tamis/error.hpp"
#include "topology/at.hpp"
#include "topology/mean_edge.hpp"

namespace tamis {
namespace {

constexpr double kShortestPiece = 0x1p-20;

/// length_of takes 20 ns, of each vertex of each piece.
double length(const Point& x) {
  const double square = x[0] * x[0] + x[1] * x[1] + x[2] * x[2];
  return 0x1p-900 < square && square < 0x1p900 ? std::sqrt(square) : length_of(x[0], x[1], x[2]);
}

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
    : mesh_(mesh), path_(path), ends_(ends), all_(numbers_of(mesh, path_)) {}

Frame MeshPieces::next(const Frame& from) {
  Frame to = frame_at(end_of(from));
  read(from.time, to.time, deviations_);
  set_lines(from, to);
  return to;
}

Frame MeshPieces::frame_at(double time) const {
  Frame frame{time, std::vector<Point>(all_.size()), std::vector<double>(all_.size())};
  path_.points_at(time, all_, frame.points, frame.errors);
  for (const Index v : mesh_.points()) check_point(v, time, frame.points[at(v)], frame.errors[at(v)]);
  return frame;
}

double MeshPieces::read(double from, double to, std::vector<double>& deviations) const {
  deviations.resize(all_.size());
  path_.deviations(from, to, all_, deviations);
  double largest = 0;
  for (const Index v : mesh_.points()) {
    check_deviation(v, from, to, deviations[at(v)]);
    largest = std::max(largest, deviations[at(v)]);
  }
  return largest;
}

double MeshPieces::end_of(const Frame& start) {
  if (!ends_.empty()) return *std::ranges::upper_bound(ends_, start.time);
  const double allowed = deviation_in_edges_ * mean_edge(mesh_, start.points);
  double length = 1 - start.time;
  for (; length > kShortestPiece; length *= kNearMiddle) {
    const double largest = kPartBesideLine * read(start.time, start.time + length, deviations_);
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
  read(0, 1, deviations_);
  double farthest = 0;
  for (const Index index : mesh_.points()) {
    const std::size_t v = at(index);
    Point way{};
    for (std::size_t k = 0; k < 3; ++k)
      way[k] = std::fabs(to.points[v][k] - from.points[v][k]) + from.errors[v] + to.errors[v];
    farthest = std::max(farthest, length_of(way[0], way[1], way[2]) + deviations_[v]);
  }
  return farthest;
}

/// On either half of the piece the curve is within that half's bound of its chord; these two chords meet where the path
/// is in the middle. Beside the piece's own chord that place is D, the ends are 0, and what is between lies at each
/// time on the segment from 0 to D. So from the piece's chord moved by D / 2 the curve is no farther than |D| / 2 and
/// the larger bound of the halves. Where bounds go by the square, |D| is at most the piece's, and those of halves are a
/// fourth of it: kPartBesideLine.
void MeshPieces::set_lines(const Frame& from, const Frame& to) {
  const Frame middle = frame_at(0.5 * from.time + 0.5 * to.time);
  read_halves(from.time, middle.time, to.time);
  lines_.start = from.points;
  lines_.end = to.points;
  lines_.deviations = deviations_;
  for (const Index index : mesh_.points()) {
    const std::size_t v = at(index);
    const Beside beside = beside_chord(v, from, middle, to);
    const double distance = length(beside.off), bound = deviations_[v];
    if (!(distance <= bound + beside.error))
      throw InvalidPath("vertex " + std::to_string(index) + " of the path is " + number_text(distance) +
                        " from its chord at t = " + number_text(middle.time) + ", beyond its bound " +
                        number_text(bound) + ": give a bound that holds");
    const double deviation = (0.5 * distance + beside.error + of_halves_[v]) * kRoundedUp;
    if (!(deviation < bound)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      lines_.start[v][k] += 0.5 * beside.off[k];
      lines_.end[v][k] += 0.5 * beside.off[k];
    }
    lines_.deviations[v] = deviation;
  }
}

/// What is computed is off by no more than `error` says: by all three positions, each on three axes, sqrt(3) times as
/// far, for which there is 2; by 8 roundings of numbers no larger than `size`; and by the time of the middle, which is
/// rounded by 2^-53, and so much of the way.
MeshPieces::Beside MeshPieces::beside_chord(std::size_t v, const Frame& from, const Frame& middle,
                                            const Frame& to) const {
  Beside beside{};
  double size = 0, way = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double p = from.points[v][k], q = to.points[v][k], x = middle.points[v][k];
    beside.off[k] = x - (0.5 * p + 0.5 * q);
    size = std::max({size, std::fabs(x), std::fabs(p), std::fabs(q)});
    way = std::max(way, std::fabs(0.5 * q - 0.5 * p));
  }
  const double errors = middle.errors[v] + from.errors[v] + to.errors[v];
  beside.error = 2 * errors + 0x1p-48 * size + 0x1p-49 / (to.time - from.time) * way;
  return beside;
}

/// Without a middle there is no bound.
void MeshPieces::read_halves(double from, double middle, double to) {
  of_halves_.assign(all_.size(), std::numeric_limits<double>::infinity());
  if (!(from < middle && middle < to)) return;
  std::vector<double> of_second;
  read(from, middle, of_halves_);
  read(middle, to, of_second);
  for (const Index v : mesh_.points()) of_halves_[at(v)] = std::max(of_halves_[at(v)], of_second[at(v)]);
}

}  // namespace tamis
