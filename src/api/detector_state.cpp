#include "api/detector_state.hpp"

#include <algorithm>

#include "api/enum_names.hpp"
#include "api/pair_faults.hpp"
#include "api/stored.hpp"
#include "api/truncation.hpp"
#include "api/validate.hpp"
#include "numbers/assert.hpp"
#include "numbers/held_bytes.hpp"
#include "numbers/in_parts.hpp"
#include "numbers/number_text.hpp"
#include "pair/narrow/near_pair.hpp"
#include "search/query/cancellation.hpp"
#include "search/query/pair_vertices.hpp"
#include "tamis/error.hpp"

namespace tamis {
namespace {

bool are_zero(const std::vector<double>& radii) {
  return std::ranges::all_of(radii, [](double radius) { return radius == 0; });
}

/// The radius of each vertex; empty if all are zero.
std::vector<double> radii_of(const Options& options, const Mesh& mesh) {
  if (are_zero(options.radii)) return {};
  const std::vector<Index>& group = options.filter.group_of_vertex;
  std::vector<double> radii(static_cast<std::size_t>(mesh.vertex_count()), options.radii[0]);
  for (std::size_t v = 0; v < group.size(); ++v)
    if (group[v] >= 0) radii[v] = options.radii[static_cast<std::size_t>(group[v])];
  return radii;
}

Options valid(Options options, const Mesh& mesh) {
  validate(options, mesh);
  return options;
}

}  // namespace

Detector::State::State(Mesh m, Options o, const MakeEngine& make_engine)
    : mesh(std::move(m)),
      options(valid(std::move(o), mesh)),
      rings_(mesh, options.filter.rings),
      arena_(options),
      radii_(radii_of(options, mesh)),
      engine_(make_engine(mesh, options)) {}

void Detector::State::set_radii(std::vector<double> radii) {
  TAMIS_ASSERT(radii.size() == static_cast<std::size_t>(mesh.vertex_count()) && options.radii.empty());
  radii_ = are_zero(radii) ? std::vector<double>() : std::move(radii);
}

Separations Detector::State::separations(double fixed) const {
  const Separations result{fixed, radii_};
  validate(result);
  return result;
}

/// Entering an arena takes a fiftieth of a question about a dozen triangles.
template <class Work>
void Detector::State::in_arena_if_long(const Work& work) {
  if (mesh.points().size() > kVerticesPerPart)
    arena_.run(work);
  else
    work();
}

Query Detector::State::asked_query(const Step& step, const QueryOptions& asked, Question question,
                                   const BodyPairs* each_of) const {
  Query result = query(step, separations(asked.min_separation.value_or(options.min_separation)), question);
  result.ignores_start = asked.at_start == AtStart::ignore;
  result.each_of = each_of;
  return result;
}

Query Detector::State::validated_query(const Step& step, const QueryOptions& asked, Question question,
                                       const BodyPairs* each_of) {
  validate(asked);
  in_arena_if_long([&] { validate(step, mesh); });
  Query result = asked_query(step, asked, question, each_of);
  if (frame_) result.frame = &*frame_;
  return result;
}

EarliestContact Detector::State::find(const Query& query) {
  EarliestContact first;
  measure([&] {
    bound_.begin(1, query.answers());
    found.begin(query, bound_);
    engine_->find(query, found, statistics);
    if (query.each_of)
      found.contacts() = found.firsts();
    else if (query.question == Question::earliest)
      first = found.first();
    sort_found();
    statistics.ignored = found.ignored();
  });
  return first;
}

void Detector::State::refuse_start(const Query& query, const Contact& touching) const {
  const double separation = query.separations.between(touching.kind, touching.vertices);
  throw InvalidStep(features_text(touching.kind, touching.vertices) + " touch at the start of the step" +
                    (separation > 0 ? ", within " + number_text(separation) + " of each other" : "") +
                    ": move them apart, leave the pair out, or pass at_start ignore");
}

EarliestContact Detector::State::find(const Step& step, const QueryOptions& asked, Question question,
                                      const BodyPairs* each_of) {
  const Query whole = validated_query(step, asked, question, each_of);
  const EarliestContact first = find(whole);
  if (asked.at_start != AtStart::fail) return first;
  if (first.contact && first.toi_upper == 0) refuse_start(whole, *first.contact);
  for (const Contact& c : found.contacts())
    if (c.toi_upper == 0) refuse_start(whole, c);
  return first;
}

void Detector::State::sort_found() {
  sorter_.sort(found.contacts(), mesh.vertex_count(), [this] { stop_if_cancelled(options); });
}

SafeStep Detector::State::safe_step(const Step& step, double keep, const QueryOptions& asked) {
  validate_kept(keep);
  if (keep > 0) return step_length(validated_query(step, asked), keep, asked.at_start);
  const EarliestContact first = earliest(step, asked);
  if (!first.contact) return {};
  const Contact& c = *first.contact;
  return {first.toi_lower, first.toi_upper, near_pair(c.kind, c.vertices, points_of(step, c.vertices))};
}

SafeStep Detector::State::step_length(const Query& query, double keep, AtStart at_start) {
  SafeStep answer;
  measure([&] { answer = engine_->find_step_length(query, keep, statistics); });
  if (at_start != AtStart::fail || answer.toi_lower > 0) return answer;
  const Statistics of_answer = statistics;  // lower is 0, too, if a distance shrinks at once
  Query at_rest = query;
  at_rest.step.end = query.step.start;
  at_rest.question = Question::earliest;
  if (const EarliestContact first = find(at_rest); first.contact) refuse_start(query, *first.contact);
  statistics = of_answer;
  return answer;
}

TruncatedStep Detector::State::truncate(const Step& step, double keep, const QueryOptions& asked, StoredType stored) {
  validate_kept_of_truncate(keep);
  validate_is_named(stored, "stored type");
  Query whole = validated_query(step, asked);
  if (stored == StoredType::float64) return truncate(whole, keep, asked.at_start, stored);
  validate_stored(step, mesh, stored);
  const std::vector<Point> end = rounded(step.end, stored);
  whole.step.end = end;
  return truncate(whole, keep, asked.at_start, stored);
}

TruncatedStep Detector::State::truncate(const Query& whole, double keep, AtStart at_start, StoredType stored) {
  const KeptFractions fractions(keep);
  const double common_time = step_length(whole, fractions.together, at_start).toi_lower;
  TruncatedStep answer;
  measure_more([&] { answer = Truncation(mesh, whole, fractions, stored, *engine_, statistics).run(common_time); });
  return answer;
}

const std::vector<NearPair>& Detector::State::find_near(const Positions& positions, double distance) {
  validate_distance(distance, "the distance");
  in_arena_if_long([&] { validate(positions, mesh, "the pose"); });
  const Query asked = query({positions, positions}, separations(distance));
  measure([&] { engine_->find_near(asked, near_, statistics); });
  return near_;
}

const std::vector<Intersection>& Detector::State::find_intersections(const Positions& positions, Question question,
                                                                     bool by_accepts) {
  in_arena_if_long([&] { validate(positions, mesh, "the pose"); });
  Query asked = query({positions, positions}, {}, question);
  asked.accepts_intersections = by_accepts;
  measure([&] { engine_->find_intersections(asked, intersections_, statistics); });
  return intersections_;
}

std::uint64_t Detector::State::memory_bytes() const {
  return held_bytes(engine_, sorter_, found, near_, intersections_, radii_, options.filter.group_of_vertex,
                    options.filter.groups_may_touch, rings_);
}

}  // namespace tamis
