#include "curves/paths/mesh_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "curves/paths/path_reader.hpp"
#include "numbers/error_bounds.hpp"
#include "numbers/length.hpp"
#include "numbers/number_text.hpp"
#include "pair/motion/time_clip.hpp"
#include "search/topology/at.hpp"
#include "search/topology/mean_edge.hpp"
#include "tamis/error.hpp"

namespace tamis {
namespace {

constexpr double kShortestPiece = 0x1p-20;
/// Shorter pieces than this follow the longest edge. Parts of very different sizes would need a million pieces.
constexpr double kShortestFinePiece = 0x1p-8;

double longest_edge(const Mesh& mesh, const Positions& points) {
  double longest = 0;
  for (const Edge& edge : mesh.edges()) longest = std::max(longest, edge_length(edge, points));
  return longest;
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

MeshPieces::MeshPieces(const Mesh& mesh, const Path& path, std::span<const double> ends, double separation)
    : mesh_(mesh), path_(path), ends_(ends), separation_(separation), all_(numbers_of(mesh, path_)) {}

MeshMoment MeshPieces::next(const MeshMoment& from) {
  MeshMoment to = moment_at(end_of(from));
  shift_chords(from, to);
  return to;
}

MeshMoment MeshPieces::moment_at(double time) const {
  MeshMoment moment{time, std::vector<Point>(all_.size()), std::vector<double>(all_.size())};
  path_.points_at(time, all_, moment.points, moment.errors);
  for (const Index v : mesh_.points()) check_point(v, time, moment.points[at(v)], moment.errors[at(v)]);
  return moment;
}

std::vector<double> MeshPieces::deviations(double from, double to) const {
  std::vector<double> deviations(all_.size());
  path_.deviations(from, to, all_, deviations);
  for (const Index v : mesh_.points()) check_deviation(v, from, to, deviations[at(v)]);
  return deviations;
}

/// A few vertices may deviate more than allowed, such as vertices far from an axis of rotation. Their number may be n
/// if n^2 is at most a sixteenth of the number of vertices.
double MeshPieces::end_of(const MeshMoment& start) const {
  if (!ends_.empty()) return *std::ranges::upper_bound(ends_, start.time);
  double allowed = deviation_in_units_ * std::max(mean_fine_edge(mesh_, start.points), separation_);
  double length = 1 - start.time;
  for (bool is_fine = true; allowed > 0 && length > kShortestPiece; length *= kNearMiddle) {
    if (is_fine && length <= kShortestFinePiece) {
      allowed = std::max(allowed, deviation_in_units_ * longest_edge(mesh_, start.points));
      is_fine = false;
    }
    const std::vector<double> bounds = deviations(start.time, start.time + length);
    const auto deviates_more = [&](Index v) { return kShiftedChordPart * bounds[at(v)] > allowed; };
    const auto count = static_cast<std::size_t>(std::ranges::count_if(mesh_.points(), deviates_more));
    constexpr std::size_t kVerticesPerPairOfThem = 16;
    if (kVerticesPerPairOfThem * count * count <= mesh_.points().size()) break;
  }
  return length < 1 - start.time ? start.time + length : 1;
}

void MeshPieces::adapt_length(std::size_t pairs) {
  constexpr std::size_t kVerticesPerPairIfFew = 32, kVerticesPerPairIfMany = 8;
  constexpr double kFactor = 4;  // deviations of a piece twice as long
  const std::size_t vertices = mesh_.points().size();
  if (kVerticesPerPairIfFew * pairs <= vertices)
    deviation_in_units_ = std::min(kFactor * deviation_in_units_, kMostChordDeviationInEdges);
  else if (kVerticesPerPairIfMany * pairs > vertices)
    deviation_in_units_ = std::max(deviation_in_units_ / kFactor, kChordDeviationInEdges);
}

std::vector<double> MeshPieces::displacements(const MeshMoment& from, const MeshMoment& to) const {
  const std::vector<double> bounds = deviations(from.time, to.time);
  std::vector<double> farthest(all_.size());
  for (const Index index : mesh_.points()) {
    const std::size_t v = at(index);
    Point displacement{};
    for (std::size_t k = 0; k < 3; ++k)
      displacement[k] = std::fabs(to.points[v][k] - from.points[v][k]) + from.errors[v] + to.errors[v];
    farthest[v] = length_of(displacement[0], displacement[1], displacement[2]) + bounds[v];
  }
  return farthest;
}

/// On either half of the piece the curve is within that half's bound of that half's chord. These two chords meet at the
/// path's position in the middle. Relative to the piece's chord they lead from 0 to an offset D and back to 0. So they
/// stay on the segment from 0 to D. Hence the curve is no farther than |D| / 2 plus the larger bound of the halves from
/// the piece's chord shifted by D / 2. If bounds go by the square of the length, |D| is at most the piece's bound. The
/// bounds of the halves are a fourth of it: 1/2 + 1/4 = kShiftedChordPart.
void MeshPieces::shift_chords(const MeshMoment& from, const MeshMoment& to) {
  chords_ = {from.points, to.points, deviations(from.time, to.time)};
  const MeshMoment middle = moment_at(0.5 * from.time + 0.5 * to.time);
  const std::vector<double> of_halves = half_deviations(from.time, middle.time, to.time);
  for (const Index index : mesh_.points()) {
    const std::size_t v = at(index);
    const auto [offset, error] = chord_offset(v, from, middle, to);
    const double distance = quick_length_of(offset[0], offset[1], offset[2]), bound = chords_.deviations[v];
    if (!(distance <= bound + error))
      throw InvalidPath("vertex " + std::to_string(index) + " of the path is " + number_text(distance) +
                        " from its chord at t = " + number_text(middle.time) + ", beyond its bound " +
                        number_text(bound) + ": give a bound that holds");
    const double deviation = (0.5 * distance + error + of_halves[v]) * kRoundedUp;
    if (!(deviation < bound)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      chords_.start[v][k] += 0.5 * offset[k];
      chords_.end[v][k] += 0.5 * offset[k];
    }
    chords_.deviations[v] = deviation;
  }
}

/// `error` covers the errors of all three positions, times 2 >= sqrt(3) for the three axes. It covers 8 roundings of
/// numbers no larger than `size`, and the rounding of the middle's time by 2^-53, times the displacement.
MeshPieces::ChordOffset MeshPieces::chord_offset(std::size_t v, const MeshMoment& from, const MeshMoment& middle,
                                                 const MeshMoment& to) const {
  ChordOffset result{};
  double size = 0, displacement = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double p = from.points[v][k], q = to.points[v][k], x = middle.points[v][k];
    result.offset[k] = x - (0.5 * p + 0.5 * q);
    size = std::max({size, std::fabs(x), std::fabs(p), std::fabs(q)});
    displacement = std::max(displacement, std::fabs(0.5 * q - 0.5 * p));
  }
  const double errors = middle.errors[v] + from.errors[v] + to.errors[v];
  result.error = 2 * errors + 0x1p-48 * size + 0x1p-49 / (to.time - from.time) * displacement;
  return result;
}

std::vector<double> MeshPieces::half_deviations(double from, double middle, double to) const {
  if (!(from < middle && middle < to)) return std::vector<double>(all_.size(), std::numeric_limits<double>::infinity());
  std::vector<double> larger = deviations(from, middle);
  const std::vector<double> of_second = deviations(middle, to);
  for (const Index v : mesh_.points()) larger[at(v)] = std::max(larger[at(v)], of_second[at(v)]);
  return larger;
}

}  // namespace tamis
