#include "api/truncation.hpp"

#include <algorithm>

#include "numbers/assert.hpp"
#include "numbers/in_parts.hpp"
#include "numbers/length.hpp"
#include "pair/exact/start_distance.hpp"
#include "pair/narrow/near_pair.hpp"
#include "search/query/cancellation.hpp"
#include "search/query/pair_vertices.hpp"
#include "search/topology/at.hpp"
#include "search/topology/mean_edge.hpp"
#include "search/topology/neighbourhood_maximum.hpp"

namespace tamis {
namespace {

/// After the common time no vertex goes farther than this many mean edges. Farther away it could meet too many pairs.
/// If a part of the scene is much finer than the mean, such as a cloth above a terrain, each body's own mean edges
/// count.
constexpr double kFarthestInMeanEdges = 0.25, kMuchFiner = 0.25;
/// Rounds in which only broken pairs get planes. In a stack each body stops one round after the one below. Recorded
/// steps take 3 to 20.
constexpr int kRounds = 32;
/// Rounds in which all pairs have planes, and only vertices of broken pairs go back. After these rounds all vertices go
/// back to the start.
constexpr int kRoundsOnOwnSides = 8;
/// A pair that starts within its separation must keep this part of its distance.
constexpr double kAllButAMillionth = 1 - 0x1p-20;
/// The parts of loops that threads share. A pair takes a microsecond or two, some take fifty.
constexpr std::size_t kPairsPerPart = 64;

/// Calls f(i) for i from 0 to `count`, by several threads. Throws Cancelled.
template <class F>
void for_each_pair(std::size_t count, const Query& query, const F& f) {
  in_parts(count, kPairsPerPart, [&](std::size_t begin, std::size_t end) {
    for (; begin != end; ++begin) {
      if (begin % kPairsPerPart == 0) stop_if_cancelled(query);
      f(begin);
    }
  });
}

/// times_of(pair) of each pair, called by several threads.
template <class Pair, class TimesOf>
std::vector<std::array<double, 4>> planar_times_of(const std::vector<Pair>& pairs, const Query& query,
                                                   const TimesOf& times_of) {
  std::vector<std::array<double, 4>> times(pairs.size());
  for_each_pair(pairs.size(), query, [&](std::size_t i) { times[i] = times_of(pairs[i]); });
  return times;
}

double displacement_length(const Step& step, Index v) {
  const double *from = step.start[v], *to = step.end[v];
  return length_of(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
}

}  // namespace

Truncation::Truncation(const Mesh& mesh, const Query& query, const KeptFractions& fractions, StoredType stored,
                       Engine& engine, Statistics& statistics)
    : mesh_(mesh),
      query_(query),
      step_(query.step),
      fractions_(fractions),
      stored_(stored),
      engine_(engine),
      statistics_(statistics) {
  TAMIS_ASSERT(step_.start.count() == mesh.vertex_count() && step_.end.count() == mesh.vertex_count());
}

TruncatedStep Truncation::run(double common_time) {
  TAMIS_ASSERT(0 <= common_time && common_time <= 1);
  begin(common_time);
  if (common_time == 1) return std::move(result_);
  for (auto broken = broken_pairs(); !broken.empty(); broken = broken_pairs()) {
    const bool is_by_rounding =  // some pair is broken although none of its vertices goes on alone
        !std::ranges::all_of(broken, [this](const StepLimit& pair) { return goes_on_alone(pair); });
    ++rounds_;
    if (!on_own_sides_ && (is_by_rounding || rounds_ > kRounds)) {
      begin_on_own_sides();
      continue;
    }
    stop_at_planes(broken);
    if (on_own_sides_ && rounds_ > kRoundsOnOwnSides)
      for (const Index v : mesh_.points()) stop(v, 0);
  }
  return std::move(result_);
}

void Truncation::begin(double common_time) {
  common_time_ = common_time;
  rounds_ = 0;
  changed_.clear();
  const auto count = at(mesh_.vertex_count());
  result_ = {std::vector<Point>(count), std::vector<double>(count, 1), true};
  in_parts(count, kVerticesPerPart, [&](std::size_t first, std::size_t last) {
    for (; first != last; ++first) place(static_cast<Index>(first));
  });
  stop_far_motions();
}

void Truncation::stop_far_motions() {
  const double mean = mean_edge(mesh_, step_.start), fine = mean_fine_edge(mesh_, step_.start);
  if (!(mean > 0)) return;
  const auto goes_farther = [&](double length, double edge) {
    return length * (1 - common_time_) > kFarthestInMeanEdges * edge;
  };
  std::vector<double> edges;
  if (fine < kMuchFiner * mean &&
      std::ranges::any_of(mesh_.points(), [&](Index v) { return goes_farther(displacement_length(step_, v), fine); }))
    edges = mean_edges_of_bodies(mesh_, step_.start);
  for_each_in_parts(mesh_.points(), kVerticesPerPart, [&](Index v) {
    const bool has_own = !edges.empty() && edges[at(v)] > 0;  // loose points have none
    const double edge = has_own ? std::clamp(edges[at(v)], fine, mean) : mean;
    if (const double length = displacement_length(step_, v); goes_farther(length, edge))
      stop(v, common_time_ + kFarthestInMeanEdges * edge / length);
  });
}

void Truncation::begin_on_own_sides() {
  begin(0);
  on_own_sides_ = true;
  // A pair keeps its fraction of its clearance unless its vertices together move by the rest of the clearance.
  const double clearance_per_displacement = 1 / (1 - fractions_.between_planes(0));
  std::vector<double> radii = neighbourhood_maximum(mesh_, query_.separations.radii);
  radii.resize(result_.fractions.size(), 0);
  for (const Index index : mesh_.points()) {
    const auto v = at(index);
    // 0 times infinity is not a number
    const double displacement = result_.fractions[v] > 0 ? result_.fractions[v] * displacement_length(step_, index) : 0;
    radii[v] += std::min(clearance_per_displacement * displacement, 0x1p1020);
  }
  std::vector<NearPair> near;
  const Query near_start{
      {step_.start, step_.start}, {query_.separations.fixed, radii}, query_.filter, query_.rings, query_.is_cancelled};
  engine_.find_near(near_start, near, statistics_);
  const auto times = planar_times_of(near, query_, [&](const NearPair& pair) {
    const double separation = separation_of(pair);
    if (query_.ignores_start && pair.distance <= separation) return std::array{1.0, 1.0, 1.0, 1.0};
    return planar_times(pair, points_of(step_, pair.vertices), {fractions_, separation, stored_}, 0);
  });
  for (std::size_t pair = 0; pair < near.size(); ++pair) {
    if (pair % kPairsPerPart == 0) stop_if_cancelled(query_);
    for (std::size_t i = 0; i < vertex_count(near[pair].kind); ++i) stop(near[pair].vertices[i], times[pair][i]);
  }
}

/// A coordinate that is the same at both ends of the step is not rounded.
void Truncation::place(Index vertex) {
  const auto v = at(vertex);
  const double t = result_.fractions[v];
  const double *start = step_.start[vertex], *end = step_.end[vertex];
  for (std::size_t k = 0; k < 3; ++k)
    result_.positions[v][k] = t == 1                         ? end[k]
                              : t == 0 || start[k] == end[k] ? start[k]
                                                             : rounded((1 - t) * start[k] + t * end[k], stored_);
}

void Truncation::stop(Index vertex, double time) {
  double& fraction = result_.fractions[at(vertex)];
  if (!(time < fraction)) return;
  fraction = time;
  if (!changed_.empty()) changed_[at(vertex)] = 1;
  place(vertex);
}

std::vector<StepLimit> Truncation::broken_pairs() {
  Query to_result = query_;
  to_result.step = step_to_result();
  to_result.changed = changed_;
  std::vector<StepLimit> pairs;
  engine_.find_step_ends(to_result, fractions_.keep, pairs, statistics_);
  changed_.assign(result_.fractions.size(), 0);
  std::atomic<bool> some_start_within = false;
  for_each_pair(pairs.size(), query_, [&](std::size_t i) {
    if (!is_broken(pairs[i], some_start_within)) pairs[i].time = 1;
  });
  if (some_start_within) result_.is_free = false;
  std::erase_if(pairs, [](const StepLimit& pair) { return pair.time == 1; });
  return pairs;
}

void Truncation::stop_at_planes(const std::vector<StepLimit>& broken) {
  const auto times = planar_times_of(broken, query_, [&](const StepLimit& pair) {
    const PairPoints points = points_of(step_, pair.vertices);
    const NearPair there = near_pair(pair.kind, pair.vertices, at_rest_at(points, common_time_));
    return planar_times(there, points, {fractions_, separation_of(pair), stored_}, common_time_);
  });
  const std::vector<double> asked = result_.fractions;
  for (std::size_t pair = 0; pair < broken.size(); ++pair) {
    if (pair % kPairsPerPart == 0) stop_if_cancelled(query_);
    const auto& v = broken[pair].vertices;
    const std::size_t count = vertex_count(broken[pair].kind);
    bool is_stopped = false;
    for (std::size_t i = 0; i < count; ++i) is_stopped |= times[pair][i] < asked[at(v[i])];
    for (std::size_t i = 0; i < count; ++i) stop(v[i], is_stopped ? times[pair][i] : common_time_);
    changed_[at(v[0])] = 1;  // the pair is asked about again, even if none of its vertices has moved
  }
}

bool Truncation::is_broken(const StepLimit& pair, std::atomic<bool>& some_start_within) const {
  TAMIS_ASSERT(0 <= pair.time && pair.time < 1);
  const PairPoints points = points_of(step_to_result(), pair.vertices);
  if (query_.ignores_start || pair.time > 0 || !starts_within(pair.kind, points, separation_of(pair))) return true;
  some_start_within = true;
  if (points.start == points.end) return false;
  PrecisionCount decided_by;
  const DistanceRule comes_no_nearer{kAllButAMillionth, 0};
  return keeps_distance_until(pair.kind, points, comes_no_nearer, 1, decided_by) < 1;
}

bool Truncation::goes_on_alone(const StepLimit& pair) const {
  const auto* v = pair.vertices.data();
  return std::any_of(v, v + vertex_count(pair.kind), [&](Index i) { return result_.fractions[at(i)] > common_time_; });
}

}  // namespace tamis
