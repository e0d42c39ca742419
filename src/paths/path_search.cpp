#include "paths/path_search.hpp"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "numerics/assert.hpp"
#include "numerics/number_text.hpp"
#include "paths/decide_path.hpp"
#include "paths/isolated_path.hpp"
#include "paths/kept_on_path.hpp"
#include "paths/remembered_path.hpp"
#include "query/cancellation.hpp"
#include "tamis/error.hpp"
#include "topology/at.hpp"
#include "topology/mean_edge.hpp"

namespace tamis {
namespace {

constexpr double kShortestPiece = 0x1p-20;
/// Pairs that are decided together, and between two looks at whether the question is cancelled.
constexpr std::size_t kBatch = 256;
/// The first of them, where a first contact spares the rest.
constexpr std::size_t kFirstBatch = 8;

/// Ascending, each once.
std::vector<Index> vertices_of(std::span<const Contact> pairs, std::span<const std::int32_t> places) {
  std::vector<Index> vertices;
  for (const std::int32_t place : places)
    std::ranges::copy_if(pairs[at(place)].vertices, std::back_inserter(vertices), [](Index v) { return v >= 0; });
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

/// By which a pair is decided.
struct PairRule {
  double separation;
  bool ignores_start;
};
PairRule rule_of(const MeshOnPath& asked, const Path& path, const Contact& pair) {
  const PairRule rule{asked.separations.between(pair.kind, pair.vertices), asked.ignores_start};
  if (asked.keep == 0) return rule;
  const KeptSeparation kept = kept_separation(path, pair.kind, pair.vertices, {asked.keep, rule.separation});
  if (rule.ignores_start && kept.may_start_within) return rule;
  return {kept.high, false};
}

}  // namespace

Frame PathSearch::frame_at(const Path& path, double time) const {
  Frame frame{time, std::vector<Point>(all_.size()), std::vector<double>(all_.size())};
  path.points_at(time, all_, frame.points, frame.errors);
  for (const Index v : mesh_.points())
    check_point(v, time, frame.points[static_cast<std::size_t>(v)], frame.errors[static_cast<std::size_t>(v)]);
  return frame;
}

double PathSearch::read_deviations(const Path& path, double from, double to) {
  path.deviations(from, to, all_, deviations_);
  double largest = 0;
  for (const Index v : mesh_.points()) {
    check_deviation(v, from, to, deviations_[at(v)]);
    largest = std::max(largest, deviations_[at(v)]);
  }
  return largest;
}

double PathSearch::piece_length(const Path& path, const Frame& start) {
  const double allowed = deviation_in_edges_ * mean_edge(mesh_, start.points);
  double length = 1 - start.time;
  for (; length > kShortestPiece; length *= kNearMiddle) {
    const double largest = read_deviations(path, start.time, start.time + length);
    if (largest <= allowed || !(allowed > 0)) break;
  }
  return length;
}

void PathSearch::choose_deviation(std::size_t pairs) {
  constexpr std::size_t kFewOfVertices = 32, kManyOfVertices = 8;  // so manieth parts of them
  constexpr double kFactor = 4;                                    // a piece twice as long
  const std::size_t vertices = mesh_.points().size();
  if (kFewOfVertices * pairs <= vertices)
    deviation_in_edges_ = std::min(kFactor * deviation_in_edges_, kMostChordDeviationInEdges);
  else if (kManyOfVertices * pairs > vertices)
    deviation_in_edges_ = std::max(deviation_in_edges_ / kFactor, kChordDeviationInEdges);
}

double PathSearch::piece_end(const MeshOnPath& asked, const Path& path, const Frame& start) {
  if (!asked.ends.empty()) return *std::ranges::upper_bound(asked.ends, start.time);
  const double length = piece_length(path, start);
  return length < 1 - start.time ? start.time + length : 1;
}

void PathSearch::set_radii(const Separations& separations, const Frame& from, const Frame& to) {
  radii_.assign(all_.size(), 0);
  for (const Index v : mesh_.points()) radii_[at(v)] = radius_on_piece(v, deviations_[at(v)], from, to, separations);
}

void PathSearch::check_chords(const Path& path, const Frame& from, const Frame& to) const {
  const Frame middle = frame_at(path, 0.5 * from.time + 0.5 * to.time);
  for (const Index index : mesh_.points()) {
    const auto v = static_cast<std::size_t>(index);
    Point off{};
    double size = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      off[k] = middle.points[v][k] - (0.5 * from.points[v][k] + 0.5 * to.points[v][k]);
      size = std::max(size, std::fabs(middle.points[v][k]));
    }
    const double distance = std::hypot(off[0], off[1], off[2]);
    const double errors = 2 * (middle.errors[v] + from.errors[v] + to.errors[v]) + 0x1p-48 * size;
    if (distance <= deviations_[v] + errors) continue;
    throw InvalidPath("vertex " + std::to_string(index) + " of the path is " + number_text(distance) +
                      " from its chord at t = " + number_text(middle.time) + ", beyond its bound " +
                      number_text(deviations_[v]) + ": give a bound that holds");
  }
}

void PathSearch::find(const MeshOnPath& asked, Question question, std::vector<Contact>& contacts,
                      Statistics& statistics) {
  TAMIS_ASSERT(asked.separations.fixed >= 0 && std::isfinite(asked.separations.fixed) && asked.tolerance > 0);
  TAMIS_ASSERT(asked.separations.radii.empty() ||
               asked.separations.radii.size() == static_cast<std::size_t>(mesh_.vertex_count()));
  const IsolatedPath path(asked.path);
  if (path.vertex_count() != mesh_.vertex_count())
    throw InvalidPath("the path has " + std::to_string(path.vertex_count()) + " vertices, the mesh " +
                      std::to_string(mesh_.vertex_count()) + ": give a path of this mesh");
  all_.resize(static_cast<std::size_t>(mesh_.vertex_count()));
  std::iota(all_.begin(), all_.end(), 0);
  deviations_.resize(all_.size());
  contacts.clear();
  never_apart_.clear();
  deviation_in_edges_ = kChordDeviationInEdges;
  std::set<PairKey> known;
  const double reach = kept_reach(asked, path);
  for (Frame from = frame_at(path, 0); from.time < 1;) {
    stop_if_cancelled(options_);
    Frame to = frame_at(path, piece_end(asked, path, from));
    read_deviations(path, from.time, to.time);
    check_chords(path, from, to);
    set_radii(asked.separations, from, to);
    Query chords{{from.points, to.points}, {reach, radii_}, options_.filter, rings_, options_.is_cancelled};
    chords.is_piece = true;
    bound_.begin();
    found_.begin(chords, bound_);
    engine_.find(chords, found_, statistics);
    statistics.decided_by += found_.decided_by();
    choose_deviation(found_.contacts().size());
    const auto is_known = [&](const Contact& c) { return known.contains({c.kind, c.vertices}); };
    std::erase_if(found_.contacts(), is_known);
    const std::size_t before = contacts.size();
    decide_all(asked, reach, from, to, question, contacts, statistics);
    if (contacts.size() > before && question != Question::all_contacts) break;
    for (std::size_t i = before; i < contacts.size(); ++i) {
      if (i % kBatch == 0) stop_if_cancelled(options_);
      known.insert({contacts[i].kind, contacts[i].vertices});
    }
    from = std::move(to);
  }
}

/// A pair that starts c beyond its separation and keeps no more than f c has lost (1 - f) c, which is no more than how
/// far both its features go.
double PathSearch::kept_reach(const MeshOnPath& asked, const Path& path) {
  if (asked.keep == 0) return asked.separations.fixed;
  const Frame from = frame_at(path, 0), to = frame_at(path, 1);
  read_deviations(path, 0, 1);
  double farthest = 0;
  for (const Index index : mesh_.points()) {
    const auto v = static_cast<std::size_t>(index);
    Point way{};
    for (std::size_t k = 0; k < 3; ++k)
      way[k] = std::fabs(to.points[v][k] - from.points[v][k]) + from.errors[v] + to.errors[v];
    farthest = std::max(farthest, std::hypot(way[0], way[1], way[2]) + deviations_[v]);
  }
  return (asked.separations.fixed + 2 * farthest * asked.keep / (1 - asked.keep)) * (1 + 0x1p-40);
}

SafeStep PathSearch::find_step_length(const MeshOnPath& asked, Statistics& statistics) {
  std::vector<Contact> contacts;
  find(asked, Question::earliest, contacts, statistics);
  const EarliestContact first = first_of(contacts);
  if (!first.contact) return {};
  const auto& [kind, certainty, vertices, toi_lower, toi_upper, u, v, normal] = *first.contact;
  const DistanceRule rule{asked.keep, asked.separations.between(kind, vertices)};
  const KeptSeparation kept = kept_separation(asked.path, kind, vertices, rule);
  SafeStep step{toi_lower, first.toi_upper, LimitingPair{kind, vertices, kept.distance}};
  if (asked.keep > 0) {
    const PathQuestion question{asked.path, kind, vertices, kept.low, asked.tolerance, options_.is_cancelled};
    const Decision decision = decide_on_path(question, {toi_lower, 1});
    step.upper = decision.verdict == Verdict::touches ? decision.upper : 1;
  }
  return step;
}

void PathSearch::decide_all(const MeshOnPath& asked, double reach, const Frame& from, const Frame& to,
                            Question question, std::vector<Contact>& contacts, Statistics& statistics) {
  std::vector<Contact>& pairs = found_.contacts();
  std::ranges::sort(pairs, [](const Contact& a, const Contact& b) {
    return a.toi_lower != b.toi_lower ? a.toi_lower < b.toi_lower : comes_before(a, b);
  });
  parts_.begin({asked.path, {reach, asked.separations.radii}, pairs, from, to, options_.is_cancelled});
  still_never_apart_.clear();
  const TimeInterval<double> piece{from.time, to.time};
  const double start = piece.t_in, length = piece.t_out - start;
  double latest = piece.t_out;
  std::size_t most = question == Question::all_contacts ? kBatch : kFirstBatch;
  for (std::vector<std::int32_t> places = parts_.next(latest); !places.empty(); places = parts_.next(latest))
    for (std::span<const std::int32_t> rest = places; !rest.empty(); most = std::min(2 * most, kBatch)) {
      // By the pairs' times on the whole piece, which ascend: those behind are later than what has been found.
      if (start + pairs[at(rest.front())].toi_lower * length * (1 - 0x1p-40) > latest) break;
      const std::size_t count = std::min(most, rest.size());
      const double touched_by = decide(asked, piece, rest.first(count), contacts, statistics);
      if (question == Question::is_free && !contacts.empty()) return;
      if (question == Question::earliest) latest = std::min(latest, touched_by);
      rest = rest.subspan(count);
    }
  std::swap(never_apart_, still_never_apart_);
}

double PathSearch::decide(const MeshOnPath& asked, const TimeInterval<double>& piece,
                          std::span<const std::int32_t> places, std::vector<Contact>& contacts,
                          Statistics& statistics) {
  const std::vector<Contact>& pairs = found_.contacts();
  const std::vector<Index> used = vertices_of(pairs, places);
  std::vector<PairResult> results(places.size());
  std::vector<char> stays_together(places.size());
  tbb::enumerable_thread_specific<RememberedPath> paths([&] { return RememberedPath(asked.path, used); });
  tbb::parallel_for(std::size_t{0}, places.size(), [&](std::size_t i) {
    const Contact& pair = pairs[at(places[i])];
    const PairRule rule = rule_of(asked, paths.local(), pair);
    const PathQuestion question{paths.local(),   pair.kind,       pair.vertices,
                                rule.separation, asked.tolerance, options_.is_cancelled};
    Decision decision = decide_on_path(question, piece);
    const double start = piece.t_in;
    const bool is_together = rule.ignores_start && decision.verdict != Verdict::is_free && decision.lower == start &&
                             (start == 0 || never_apart_.contains({pair.kind, pair.vertices}));
    bool stays = false;
    if (is_together) decision = decide_once_apart_on_path(question, piece, stays);
    stays_together[i] = static_cast<char>(stays);
    results[i] = result_on_path(question, decision);
  });
  double touched_by = piece.t_out;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const PairResult& r = results[i];
    const Contact& pair = pairs[at(places[i])];
    if (stays_together[i]) still_never_apart_.insert({pair.kind, pair.vertices});
    statistics.decided_by.scalar += !r.touches || r.certainty == Certainty::certified;
    statistics.decided_by.unresolved += r.touches && r.certainty == Certainty::unresolved;
    if (!r.touches) continue;
    contacts.push_back(contact_of(pair.kind, pair.vertices, r));
    touched_by = std::min(touched_by, r.toi_upper);
  }
  return touched_by;
}

std::uint64_t PathSearch::memory_bytes() const {
  return found_.memory_bytes() + parts_.memory_bytes() + all_.capacity() * sizeof(Index) +
         (deviations_.capacity() + radii_.capacity()) * sizeof(double);
}

EarliestContact first_of(const std::vector<Contact>& contacts) {
  EarliestContact first;
  for (const Contact& contact : contacts) keep_first(first, contact);
  return first;
}

}  // namespace tamis
