#include "paths/path_search.hpp"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <tuple>

#include "numerics/assert.hpp"
#include "numerics/error_bounds.hpp"
#include "numerics/number_text.hpp"
#include "paths/decide_path.hpp"
#include "paths/remembered_path.hpp"
#include "paths/within_on_path.hpp"
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

using PairKey = std::tuple<PairKind, PairVertices>;
PairKey key_of(const Contact& pair) { return {pair.kind, pair.vertices}; }

}  // namespace

struct PathSearch::Run {
  PathSearch& kept;
  const MeshOnPath& asked;
  Question question;
  std::vector<Contact>& contacts;
  Statistics& statistics;
  const Mesh& mesh = kept.mesh_;
  const Options& options = kept.options_;
  const IsolatedPath path{asked.path};
  /// No pair that stays farther apart, beyond its radii, touches, or fails to keep its part.
  double reach = kept_reach();
  double deviation_in_edges = kChordDeviationInEdges;  ///< of the next piece
  std::set<PairKey> known = {};                        ///< to touch
  /// Ignored: those that touch at the start, and not since. Until when each has not been apart: the end of a piece, or
  /// the start of the one in which it came apart.
  std::map<PairKey, double> together_until = {};

  void search();
  Frame frame_at(double time) const;
  /// Of all vertices between two times. Returns the largest; throws at one that is no bound.
  double read_deviations(double from, double to) const;
  double kept_reach() const;
  double piece_end(const Frame& start) const;
  /// By how many pairs the last piece has left.
  void choose_deviation(std::size_t pairs);
  /// Throws if a vertex in the middle of its piece is farther from the chord than it says.
  void check_chords(const Frame& from, const Frame& to) const;
  /// Finds the pairs whose chords come within reach.
  void search_chords(const Frame& from, const Frame& to);
  /// What those have left of a piece.
  void decide_all(const Frame& from, const Frame& to);
  /// Of that piece, together. Returns when the first of them touches, by its bracket's end.
  double decide(const TimeInterval<double>& piece, std::span<const std::int32_t> places);
  /// Has the pair, which is ignored at the start, not been apart until this time, the start of a piece?
  bool is_together(const Contact& pair, double time) const {
    const auto found = together_until.find(key_of(pair));
    return time == 0 || (found != together_until.end() && found->second == time);
  }
};

Frame PathSearch::Run::frame_at(double time) const {
  Frame frame{time, std::vector<Point>(kept.all_.size()), std::vector<double>(kept.all_.size())};
  path.points_at(time, kept.all_, frame.points, frame.errors);
  for (const Index v : mesh.points()) check_point(v, time, frame.points[at(v)], frame.errors[at(v)]);
  return frame;
}

double PathSearch::Run::read_deviations(double from, double to) const {
  path.deviations(from, to, kept.all_, kept.deviations_);
  double largest = 0;
  for (const Index v : mesh.points()) {
    check_deviation(v, from, to, kept.deviations_[at(v)]);
    largest = std::max(largest, kept.deviations_[at(v)]);
  }
  return largest;
}

double PathSearch::Run::piece_end(const Frame& start) const {
  if (!asked.ends.empty()) return *std::ranges::upper_bound(asked.ends, start.time);
  const double allowed = deviation_in_edges * mean_edge(mesh, start.points);
  double length = 1 - start.time;
  for (; length > kShortestPiece; length *= kNearMiddle) {
    const double largest = read_deviations(start.time, start.time + length);
    if (largest <= allowed || !(allowed > 0)) break;
  }
  return length < 1 - start.time ? start.time + length : 1;
}

void PathSearch::Run::choose_deviation(std::size_t pairs) {
  constexpr std::size_t kFewOfVertices = 32, kManyOfVertices = 8;  // so manieth parts of them
  constexpr double kFactor = 4;                                    // a piece twice as long
  const std::size_t vertices = mesh.points().size();
  if (kFewOfVertices * pairs <= vertices)
    deviation_in_edges = std::min(kFactor * deviation_in_edges, kMostChordDeviationInEdges);
  else if (kManyOfVertices * pairs > vertices)
    deviation_in_edges = std::max(deviation_in_edges / kFactor, kChordDeviationInEdges);
}

void PathSearch::Run::check_chords(const Frame& from, const Frame& to) const {
  const Frame middle = frame_at(0.5 * from.time + 0.5 * to.time);
  for (const Index index : mesh.points()) {
    const std::size_t v = at(index);
    Point off{};
    double size = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      off[k] = middle.points[v][k] - (0.5 * from.points[v][k] + 0.5 * to.points[v][k]);
      size = std::max(size, std::fabs(middle.points[v][k]));
    }
    const double distance = std::hypot(off[0], off[1], off[2]), bound = kept.deviations_[v];
    const double errors = 2 * (middle.errors[v] + from.errors[v] + to.errors[v]) + 0x1p-48 * size;
    if (distance <= bound + errors) continue;
    throw InvalidPath("vertex " + std::to_string(index) + " of the path is " + number_text(distance) +
                      " from its chord at t = " + number_text(middle.time) + ", beyond its bound " +
                      number_text(bound) + ": give a bound that holds");
  }
}

/// A pair that starts c beyond its separation and keeps no more than f c has lost (1 - f) c, which is no more than how
/// far both its features go.
double PathSearch::Run::kept_reach() const {
  if (asked.keep == 0) return asked.separations.fixed;
  const Frame from = frame_at(0), to = frame_at(1);
  read_deviations(0, 1);
  double farthest = 0;
  for (const Index index : mesh.points()) {
    const std::size_t v = at(index);
    Point way{};
    for (std::size_t k = 0; k < 3; ++k)
      way[k] = std::fabs(to.points[v][k] - from.points[v][k]) + from.errors[v] + to.errors[v];
    farthest = std::max(farthest, std::hypot(way[0], way[1], way[2]) + kept.deviations_[v]);
  }
  return (asked.separations.fixed + 2 * farthest * asked.keep / (1 - asked.keep)) * kRoundedUp;
}

void PathSearch::Run::search() {
  for (Frame from = frame_at(0); from.time < 1;) {
    stop_if_cancelled(options);
    Frame to = frame_at(piece_end(from));
    read_deviations(from.time, to.time);
    check_chords(from, to);
    search_chords(from, to);
    const std::size_t before = contacts.size();
    decide_all(from, to);
    if (contacts.size() > before && question != Question::all_contacts) break;
    for (std::size_t i = before; i < contacts.size(); ++i) {
      if (i % kBatch == 0) stop_if_cancelled(options);
      known.insert(key_of(contacts[i]));
    }
    from = std::move(to);
  }
  if (asked.keep == 0) statistics.ignored += together_until.size();
}

void PathSearch::Run::search_chords(const Frame& from, const Frame& to) {
  std::vector<double>& radii = kept.radii_;
  radii.assign(kept.all_.size(), 0);
  for (const Index index : mesh.points()) {
    const std::size_t v = at(index);
    const double error = std::max(from.errors[v], to.errors[v]);
    radii[v] = radius_on_piece(index, kept.deviations_[v], error, from.time, asked.separations);
  }
  Query chords{{from.points, to.points}, {reach, radii}, options.filter, kept.rings_, options.is_cancelled};
  chords.is_piece = true;
  Bound bound;
  ContactCollector& found = kept.found_;
  found.begin(chords, bound);
  kept.engine_.find(chords, found, statistics);
  statistics.decided_by += found.decided_by();
  choose_deviation(found.contacts().size());
  std::erase_if(found.contacts(), [&](const Contact& pair) { return known.contains(key_of(pair)); });
}

void PathSearch::Run::decide_all(const Frame& from, const Frame& to) {
  std::vector<Contact>& pairs = kept.found_.contacts();
  std::ranges::sort(pairs, [](const Contact& a, const Contact& b) {
    return a.toi_lower != b.toi_lower ? a.toi_lower < b.toi_lower : comes_before(a, b);
  });
  PairsOnParts& parts = kept.parts_;
  parts.begin({asked.path, {reach, asked.separations.radii}, pairs, from, to, options.is_cancelled});
  const TimeInterval<double> piece{from.time, to.time};
  const double start = piece.t_in, length = piece.t_out - start;
  double latest = piece.t_out;
  std::size_t most = question == Question::all_contacts ? kBatch : kFirstBatch;
  for (std::vector<std::int32_t> places = parts.next(latest); !places.empty(); places = parts.next(latest))
    for (std::span<const std::int32_t> rest = places; !rest.empty(); most = std::min(2 * most, kBatch)) {
      // By the pairs' times on the whole piece, which ascend: those behind are later than what has been found.
      if (start + pairs[at(rest.front())].toi_lower * length * (1 - 0x1p-40) > latest) break;
      const std::size_t count = std::min(most, rest.size());
      const double touched_by = decide(piece, rest.first(count));
      if (question == Question::is_free && !contacts.empty()) return;
      if (question == Question::earliest) latest = std::min(latest, touched_by);
      rest = rest.subspan(count);
    }
}

double PathSearch::Run::decide(const TimeInterval<double>& piece, std::span<const std::int32_t> places) {
  struct Decided {
    PairResult result;
    std::optional<double> together_until;  ///< of one that touches at the start and is ignored
  };
  const std::vector<Contact>& pairs = kept.found_.contacts();
  const std::vector<Index> used = vertices_of(pairs, places);
  std::vector<Decided> decided(places.size());
  tbb::enumerable_thread_specific<RememberedPath> paths([&] { return RememberedPath(asked.path, used); });
  tbb::parallel_for(std::size_t{0}, places.size(), [&](std::size_t i) {
    const Contact& pair = pairs[at(places[i])];
    const PairRule rule = rule_of(asked, paths.local(), pair);
    const PathQuestion of_pair{paths.local(),   pair.kind,       pair.vertices,
                               rule.separation, asked.tolerance, options.is_cancelled};
    Decision decision = decide_on_path(of_pair, piece);
    const bool may_touch_at_start = decision.verdict != Verdict::is_free && decision.lower == piece.t_in;
    if (rule.ignores_start && may_touch_at_start && is_together(pair, piece.t_in)) {
      const auto once_apart = decide_once_apart_on_path(of_pair, piece);
      decision = once_apart.value_or(Decision{});
      decided[i].together_until = once_apart ? piece.t_in : piece.t_out;
    }
    decided[i].result = result_on_path(of_pair, decision);
  });
  double touched_by = piece.t_out;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto& [r, until] = decided[i];
    const Contact& pair = pairs[at(places[i])];
    if (until) together_until[key_of(pair)] = *until;
    statistics.decided_by.scalar += !r.touches || r.certainty == Certainty::certified;
    statistics.decided_by.unresolved += r.touches && r.certainty == Certainty::unresolved;
    if (!r.touches) continue;
    together_until.erase(key_of(pair));
    contacts.push_back(contact_of(pair.kind, pair.vertices, r));
    touched_by = std::min(touched_by, r.toi_upper);
  }
  return touched_by;
}

void PathSearch::find(const MeshOnPath& asked, Question question, std::vector<Contact>& contacts,
                      Statistics& statistics) {
  TAMIS_ASSERT(asked.separations.fixed >= 0 && std::isfinite(asked.separations.fixed) && asked.tolerance > 0);
  TAMIS_ASSERT(asked.separations.radii.empty() ||
               asked.separations.radii.size() == static_cast<std::size_t>(mesh_.vertex_count()));
  const Index vertices = asked.path.vertex_count();
  if (vertices != mesh_.vertex_count())
    throw InvalidPath("the path has " + std::to_string(vertices) + " vertices, the mesh " +
                      std::to_string(mesh_.vertex_count()) + ": give a path of this mesh");
  all_.resize(at(vertices));
  std::iota(all_.begin(), all_.end(), 0);
  deviations_.resize(all_.size());
  contacts.clear();
  Run{*this, asked, question, contacts, statistics}.search();
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
