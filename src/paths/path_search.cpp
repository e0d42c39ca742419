#include "paths/path_search.hpp"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include "numerics/assert.hpp"
#include "numerics/error_bounds.hpp"
#include "paths/cached_path.hpp"
#include "paths/decide_path.hpp"
#include "paths/mesh_pieces.hpp"
#include "paths/step_length_on_path.hpp"
#include "query/cancellation.hpp"
#include "topology/at.hpp"
#include "topology/neighbourhood_maximum.hpp"

namespace tamis {
namespace {

/// Pairs that are decided in parallel, between two checks for cancellation.
constexpr std::size_t kBatch = 256;
/// Of the first batch, where a first contact spares the rest.
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

/// How a pair is decided.
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

/// One question: what it asks, and its state from piece to piece. `owner` keeps what lasts longer.
struct PathSearch::Run {
  PathSearch& owner;
  const MeshOnPath& asked;
  Question question;
  std::vector<Contact>& contacts;
  Statistics& statistics;
  const Options& options = owner.options_;
  MeshPieces pieces{owner.mesh_, asked.path, asked.ends};
  /// A pair that stays farther apart, beyond its radii, neither touches nor fails to keep its part.
  double search_distance = distance_to_search();
  /// Deviations are added to these, vertex by vertex.
  const std::vector<double> largest_radii = neighbourhood_maximum(owner.mesh_, asked.separations.radii);
  std::set<PairKey> reported = {};  ///< pairs among the contacts
  /// Ignored pairs, which touch at the start, each with a time until which it is not known to have been apart: the end
  /// of a piece, or the start of the piece in which it came apart. Removed when the pair touches again.
  std::map<PairKey, double> in_contact_until = {};

  void search();
  double distance_to_search();
  /// Finds the pairs whose chords come within the search distance on a piece.
  void search_chords(const MeshMoment& from, const MeshMoment& to);
  /// Decides these pairs on their curves.
  void decide_all(const MeshMoment& from, const MeshMoment& to);
  /// Decides some of them, in parallel. Returns the earliest end of a bracket among those that touch.
  double decide(const TimeInterval<double>& piece, std::span<const std::int32_t> places);
  /// Is the pair, which is ignored at the start, still in its first contact at this time, the start of a piece?
  bool is_in_first_contact(const Contact& pair, double time) const {
    const auto found = in_contact_until.find(key_of(pair));
    return time == 0 || (found != in_contact_until.end() && found->second == time);
  }
};

/// A pair of clearance c that keeps no more than f c has lost (1 - f) c, which is no more than both features'
/// displacements together.
double PathSearch::Run::distance_to_search() {
  if (asked.keep == 0) return asked.separations.fixed;
  return (asked.separations.fixed + 2 * pieces.max_displacement() * asked.keep / (1 - asked.keep)) * kRoundedUp;
}

void PathSearch::Run::search() {
  for (MeshMoment from = pieces.moment_at(0); from.time < 1;) {
    stop_if_cancelled(options);
    MeshMoment to = pieces.next(from);
    search_chords(from, to);
    const std::size_t before = contacts.size();
    decide_all(from, to);
    if (contacts.size() > before && question != Question::all_contacts) break;
    for (std::size_t i = before; i < contacts.size(); ++i) {
      if (i % kBatch == 0) stop_if_cancelled(options);
      reported.insert(key_of(contacts[i]));
    }
    from = std::move(to);
  }
  if (asked.keep == 0) statistics.ignored += in_contact_until.size();
}

void PathSearch::Run::search_chords(const MeshMoment& from, const MeshMoment& to) {
  const ShiftedChords& straight = pieces.chords();
  std::vector<double>& radii = owner.radii_;
  radii.assign(from.points.size(), 0);
  for (const Index index : owner.mesh_.points()) {
    const std::size_t v = at(index);
    const double error = std::max(from.errors[v], to.errors[v]);
    radii[v] = chord_radius(index, straight.deviations[v], error, from.time, {search_distance, largest_radii});
  }
  Query chords{
      {straight.start, straight.end}, {search_distance, radii}, options.filter, owner.rings_, options.is_cancelled};
  chords.is_piece = true;
  Bound bound;
  ContactCollector& found = owner.found_;
  found.begin(chords, bound);
  owner.engine_.find(chords, found, statistics);
  statistics.decided_by += found.decided_by();
  pieces.adapt_length(found.contacts().size());
  std::erase_if(found.contacts(), [&](const Contact& pair) { return reported.contains(key_of(pair)); });
}

void PathSearch::Run::decide_all(const MeshMoment& from, const MeshMoment& to) {
  std::vector<Contact>& pairs = owner.found_.contacts();
  std::ranges::sort(pairs, [](const Contact& a, const Contact& b) {
    return a.toi_lower != b.toi_lower ? a.toi_lower < b.toi_lower : comes_before(a, b);
  });
  PairsOnParts& parts = owner.parts_;
  parts.begin({asked.path, {search_distance, largest_radii}, pairs, from, to, options.is_cancelled});
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
    std::optional<double> in_contact_until;  ///< of a pair that touches at the start and is ignored
  };
  const std::vector<Contact>& pairs = owner.found_.contacts();
  const std::vector<Index> used = vertices_of(pairs, places);
  std::vector<Decided> decided(places.size());
  tbb::enumerable_thread_specific<CachedPath> paths([&] { return CachedPath(asked.path, used); });
  tbb::parallel_for(std::size_t{0}, places.size(), [&](std::size_t i) {
    const Contact& pair = pairs[at(places[i])];
    const PairRule rule = rule_of(asked, paths.local(), pair);
    const PathQuestion of_pair{paths.local(),   pair.kind,       pair.vertices,
                               rule.separation, asked.tolerance, options.is_cancelled};
    Decision decision = decide_on_path(of_pair, piece);
    const bool may_touch_at_start = !decision.is_free() && decision.lower == piece.t_in;
    if (rule.ignores_start && may_touch_at_start && is_in_first_contact(pair, piece.t_in)) {
      const auto recontact = decide_recontact_on_path(of_pair, piece);
      decision = recontact.value_or(Decision{});
      decided[i].in_contact_until = recontact ? piece.t_in : piece.t_out;
    }
    decided[i].result = result_on_path(of_pair, decision);
  });
  double touched_by = piece.t_out;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto& [r, until] = decided[i];
    const Contact& pair = pairs[at(places[i])];
    if (until) in_contact_until[key_of(pair)] = *until;
    statistics.decided_by.scalar += !r.touches || r.certainty == Certainty::certified;
    statistics.decided_by.unresolved += r.touches && r.certainty == Certainty::unresolved;
    if (!r.touches) continue;
    in_contact_until.erase(key_of(pair));
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
  contacts.clear();
  Run{*this, asked, question, contacts, statistics}.search();
}

EarliestContact first_of(const std::vector<Contact>& contacts) {
  EarliestContact first;
  for (const Contact& contact : contacts) keep_first(first, contact);
  return first;
}

}  // namespace tamis
