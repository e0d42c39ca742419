#include "curves/paths/path_search.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "curves/paths/cached_path.hpp"
#include "curves/paths/carried_pair.hpp"
#include "curves/paths/decide_path.hpp"
#include "numbers/assert.hpp"
#include "numbers/error_bounds.hpp"
#include "numbers/in_parts.hpp"
#include "numbers/pool.hpp"
#include "search/query/cancellation.hpp"
#include "search/topology/at.hpp"
#include "search/topology/neighbourhood_maximum.hpp"

namespace tamis {
namespace {

/// Pairs that are decided in parallel, between two checks for cancellation.
constexpr std::size_t kBatch = 256;
/// Size of the first batch if the question ends with the first contact, which spares the rest.
constexpr std::size_t kFirstBatch = 8;

/// More than the rounding of a time when it is taken from the path to a piece, or back.
constexpr double kBeyondRounding = 1 + 0x1p-40;

/// The vertices of these pairs, ascending, each once.
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
/// A pair that is still keeps its whole distance.
PairRule rule_of(const MeshOnPath& asked, const CarriedPair& carried, const Contact& pair) {
  const PairRule rule{asked.query.separations.between(pair.kind, pair.vertices), asked.query.ignores_start};
  if (asked.keep == 0 || carried.is_still()) return rule;
  const KeptSeparation kept =
      kept_separation(carried.path(), pair.kind, carried.vertices(), {asked.keep, rule.separation});
  if (rule.ignores_start && kept.is_near_separation) return rule;
  return {kept.high, false};
}

}  // namespace

PathSearch::PathSearch(const Mesh& mesh, const MeshOnPath& asked, Engine& engine, const Kernels& kernels,
                       Statistics& statistics)
    : mesh_(mesh),
      asked_(asked),
      query_(asked.query),
      engine_(engine),
      statistics_(statistics),
      pieces_(mesh, asked.path, asked.ends, asked.query.separations.fixed),
      start_(pieces_.moment_at(0)),
      parts_(kernels) {
  const auto& [fixed, radii] = query_.separations;
  TAMIS_ASSERT(fixed >= 0 && std::isfinite(fixed) && asked.tolerance > 0);
  TAMIS_ASSERT(radii.empty() || radii.size() == at(mesh.vertex_count()));
}

/// A pair of clearance c that keeps no more than f c has lost (1 - f) c. That is at most w, both features'
/// displacements until then together. So f c is at most f / (1 - f) w. Each feature adds its own displacement's part.
/// So whether a pair is tested depends on the pair alone.
std::vector<double> PathSearch::radii_to_search(const MeshMoment& to) const {
  std::vector<double> radii = neighbourhood_maximum(mesh_, query_.separations.radii);
  if (asked_.keep == 0) return radii;
  radii.resize(at(mesh_.vertex_count()));
  const std::vector<double> displacements = pieces_.displacements(start_, to);
  for (std::size_t v = 0; v < radii.size(); ++v)
    radii[v] = (radii[v] + displacements[v] * asked_.keep / (1 - asked_.keep)) * kRoundedUp;
  return neighbourhood_maximum(mesh_, radii);
}

std::vector<Contact> PathSearch::find() {
  bound_.begin(1, query_.answers());
  for (MeshMoment from = start_; from.time < 1 && from.time <= bound_.latest() && !bound_.is_settled();) {
    stop_if_cancelled(query_);
    MeshMoment to = pieces_.next(from);
    if (from.time == 0 || asked_.keep > 0) searched_radii_ = radii_to_search(to);
    searched_ = {query_.separations.fixed, searched_radii_};
    search_chords(from, to);
    const std::size_t before = contacts_.size();
    decide_all(from, to);
    for (std::size_t i = before; i < contacts_.size(); ++i) {
      if (i % kBatch == 0) stop_if_cancelled(query_);
      settled_.insert(key_of(contacts_[i]));
    }
    from = std::move(to);
  }
  if (asked_.keep == 0) statistics_.ignored += in_contact_until_.size();
  if (query_.each_of) keep_firsts(query_, contacts_);
  return std::move(contacts_);
}

void PathSearch::search_chords(const MeshMoment& from, const MeshMoment& to) {
  const ShiftedChords& straight = pieces_.chords();
  std::vector<double> radii(from.points.size());
  for (const Index index : mesh_.points()) {
    const std::size_t v = at(index);
    const double error = std::max(from.errors[v], to.errors[v]);
    radii[v] = chord_radius(index, straight.deviations[v], error, from.time, searched_);
  }
  Query chords{
      {straight.start, straight.end}, {searched_.fixed, radii}, query_.filter, query_.rings, query_.is_cancelled};
  chords.is_piece = true;
  chords.each_of = query_.each_of;
  begin_bound_on_piece({from.time, to.time});
  candidates_.begin(chords, bound_on_piece_);
  engine_.find(chords, candidates_, statistics_);
  std::size_t looked_at = 0;
  std::erase_if(candidates_.contacts(), [&](const Contact& pair) {
    if (++looked_at % kBatch == 0) stop_if_cancelled(query_);
    return settled_.contains(key_of(pair));
  });
  pieces_.adapt_length(candidates_.contacts().size());
}

/// If curves that come near after some time of the piece may be skipped, so may chords that come near after it.
void PathSearch::begin_bound_on_piece(const TimeInterval<double>& piece) {
  bound_on_piece_.begin(1, query_.answers());
  for (std::size_t answer = 0; answer < query_.answers(); ++answer) {
    const double latest = bound_.latest(answer);
    const double on_piece = (latest - piece.t_in) / (piece.t_out - piece.t_in) * kBeyondRounding;
    bound_on_piece_.lower(latest < piece.t_in ? Bound::kNever : on_piece, answer);
  }
}

void PathSearch::decide_all(const MeshMoment& from, const MeshMoment& to) {
  std::vector<Contact>& pairs = candidates_.contacts();
  const auto is_earlier = [](const Contact& a, const Contact& b) {
    return a.toi_lower != b.toi_lower ? a.toi_lower < b.toi_lower : comes_before(a, b);
  };
  const auto pause = [&] { stop_if_cancelled(query_); };
  std::sort(pairs.begin(), pairs.end(), pausing(is_earlier, pause));
  parts_.begin({asked_.path, searched_, pairs, from, to, query_.is_cancelled});
  const TimeInterval<double> piece{from.time, to.time};
  // Pairs ascend by these times, so an early contact spares later ones.
  const auto is_wanted = [&](std::int32_t place) {
    const Contact& pair = pairs[at(place)];
    return wants(pair, piece.t_in + pair.toi_lower * (piece.t_out - piece.t_in) / kBeyondRounding);
  };
  const PairsOnParts::Wants wants_it = [this](const Contact& pair, double from_time) { return wants(pair, from_time); };
  std::size_t most = query_.question == Question::all_contacts ? kBatch : kFirstBatch;
  std::vector<std::int32_t> batch;
  for (std::vector<std::int32_t> places = parts_.next(wants_it); !places.empty(); places = parts_.next(wants_it))
    for (auto place = places.begin(); place != places.end(); most = std::min(2 * most, kBatch)) {
      for (batch.clear(); place != places.end() && batch.size() < most; ++place)
        if (is_wanted(*place)) batch.push_back(*place);
      decide(piece, batch);
    }
}

void PathSearch::decide(const TimeInterval<double>& piece, std::span<const std::int32_t> places) {
  struct Decided {
    PairResult result;
    std::optional<double> in_contact_until;  ///< of a pair that touches at the start and is ignored
    bool is_settled = false;
  };
  const std::vector<Contact>& pairs = candidates_.contacts();
  const std::vector<Index> used = vertices_of(pairs, places);
  std::vector<Decided> decided(places.size());
  Pool<CachedPath> paths([&](std::size_t) { return std::make_unique<CachedPath>(asked_.path, used); });
  const auto decide_one = [&](std::size_t i) {
    stop_if_cancelled(query_);
    const Contact& pair = pairs[at(places[i])];
    const auto path = paths.take();
    const CarriedPair carried(*path, pair.kind, pair.vertices);
    const PairRule rule = rule_of(asked_, carried, pair);
    const PathQuestion of_pair{carried.path(),  pair.kind,        carried.vertices(),
                               rule.separation, asked_.tolerance, query_.is_cancelled};
    const TimeInterval<double> time = carried.is_still() ? TimeInterval<double>{0, 1} : piece;
    Decision decision = decide_on_path(of_pair, time);
    const bool may_touch_at_start = !decision.is_free() && decision.lower == time.t_in;
    if (rule.ignores_start && may_touch_at_start && is_in_first_contact(pair, time.t_in)) {
      std::optional<Decision> recontact;
      if (!carried.is_still()) recontact = decide_recontact_on_path(of_pair, time);
      decision = recontact.value_or(Decision{});
      decided[i].in_contact_until = recontact ? time.t_in : time.t_out;
    }
    decided[i].result = carried.in_world(result_on_path(of_pair, decision));
    decided[i].is_settled = carried.is_still();
  };
  parallel_for(places.size(), 1, [&](std::size_t i, std::size_t end) {
    for (; i != end; ++i) decide_one(i);
  });
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto& [r, until, is_settled] = decided[i];
    const Contact& pair = pairs[at(places[i])];
    if (is_settled) settled_.insert(key_of(pair));
    if (until) in_contact_until_[key_of(pair)] = *until;
    statistics_.decided_by.scalar += !r.touches || r.certainty == Certainty::certified;
    statistics_.decided_by.unresolved += r.touches && r.certainty == Certainty::unresolved;
    if (!r.touches) continue;
    in_contact_until_.erase(key_of(pair));
    contacts_.push_back(contact_of(pair.kind, pair.vertices, r));
    if (query_.question == Question::is_free) bound_.settle();
    // Certified brackets are no wider than the tolerance. The bracket of a pair that touches later begins later than
    // this.
    if (query_.question == Question::earliest)
      bound_.lower(r.toi_upper + asked_.tolerance, query_.answer_of(pair.kind, pair.vertices));
  }
}

EarliestContact first_of(const std::vector<Contact>& contacts) {
  EarliestContact first;
  for (const Contact& contact : contacts) keep_first(first, contact);
  return first;
}

}  // namespace tamis
