#include "detect/detector_state.hpp"

#include <algorithm>

#include "detect/stored.hpp"
#include "detect/truncation.hpp"
#include "detect/validate.hpp"
#include "engines/cancellation.hpp"
#include "engines/pair_rules.hpp"
#include "engines/stopwatch.hpp"
#include "exact/start_distance.hpp"
#include "numerics/number_text.hpp"
#include "tamis/error.hpp"

namespace tamis {
namespace {

std::unique_ptr<Engine> make_engine(const Mesh& mesh, const Options& options) {
  switch (options.method) {
    case Method::tamis:
      return make_tamis_engine(mesh, options);
    case Method::paper:
      return make_paper_engine(mesh, options);
    case Method::brute:
      return make_brute_engine(mesh, options);
  }
  throw InvalidOptions("unknown method");
}

/// Of each vertex; empty where all are zero.
std::vector<double> radii_of(const Options& options, const Mesh& mesh) {
  const auto is_zero = [](double radius) { return radius == 0; };
  if (std::all_of(options.thickness.begin(), options.thickness.end(), is_zero)) return {};
  const std::vector<Index>& group = options.filter.group_of_vertex;
  std::vector<double> radii(static_cast<std::size_t>(mesh.vertex_count()), options.thickness[0]);
  for (std::size_t v = 0; v < group.size(); ++v)
    if (group[v] >= 0) radii[v] = options.thickness[static_cast<std::size_t>(group[v])];
  return radii;
}

void validate_kept_part(double fraction) {
  if (!(fraction > 0 && fraction < 1))
    throw InvalidOptions("the fraction of the distance to keep is " + number_text(fraction) +
                         ": give a number > 0 and < 1");
}

}  // namespace

Detector::State::State(Mesh m, Options o) : mesh(std::move(m)), options(std::move(o)), arena_(options.threads) {
  validate(options, mesh);
  radii_ = radii_of(options, mesh);
  engine_ = make_engine(mesh, options);
}

Separations Detector::State::separations(Separation min_separation) const {
  if (min_separation) validate_distance(*min_separation, "the minimum separation");
  return {min_separation.value_or(options.min_separation), radii_};
}

void Detector::State::ask(const Step& step, Separation min_separation, Question question) {
  const Separations kept = separations(min_separation);
  validate(step, mesh);
  measure([&] {
    found.begin(step, kept, question);
    engine_->find(found, statistics);
    if (question == Question::all_contacts) sort_found();
  });
}

void Detector::State::ask(const Path& path, Separation min_separation, double tolerance, Question question) {
  const Separations kept = separations(min_separation);
  validate_tolerance(tolerance);
  measure([&] {
    if (!path_search_) path_search_ = std::make_unique<PathSearch>(mesh, options, *engine_);
    path_search_->find({path, kept, tolerance}, question, found.contacts(), statistics);
    sort_found();
  });
}

void Detector::State::sort_found() {
  sorter_.sort(found.contacts(), mesh.vertex_count(), [this] { stop_if_cancelled(options); });
}

EarliestContact Detector::State::earliest(const Step& step, Separation min_separation) {
  ask(step, min_separation, Question::earliest);
  const EarliestContact first = found.first();
  statistics.decided_by += found.decided_by();
  return first;
}

SafeStep Detector::State::keep_distance(const Step& step, double fraction, Separation min_separation) {
  validate_kept(fraction);
  if (fraction > 0) return step_length(step, separations(min_separation), fraction);
  const EarliestContact first = earliest(step, min_separation);
  if (!first.contact) return {};
  const Contact& c = *first.contact;
  const double distance = start_distance(c.kind, points_of(step, c.vertices));
  return {first.toi_lower, first.toi_upper, LimitingPair{c.kind, c.vertices, distance}};
}

SafeStep Detector::State::step_length(const Step& step, const Separations& separations, double fraction) {
  SafeStep answer;
  validate(step, mesh);
  measure([&] { answer = engine_->find_step_length(step, separations, fraction, statistics); });
  return answer;
}

TruncatedStep Detector::State::truncate(const Step& step, double fraction, Separation min_separation, Stored stored) {
  validate_kept_part(fraction);
  const Separations kept = separations(min_separation);
  validate(step, mesh);
  if (stored == Stored::float64) return truncate(step, KeptFractions(fraction), kept, stored);
  validate_stored(step, mesh, stored);
  const std::vector<Point> end = rounded(step.end, stored);
  return truncate({step.start, end}, KeptFractions(fraction), kept, stored);
}

TruncatedStep Detector::State::truncate(const Step& step, const KeptFractions& fractions, const Separations& kept,
                                        Stored stored) {
  using Next = Truncation::Next;
  const Stopwatch watch;
  const double together = step_length(step, kept, fractions.together).lower;
  Seconds spent = statistics.seconds;
  Truncation truncation(mesh, step, kept, fractions, together, stored);
  std::vector<StepLimit> ends;
  for (Next next = together < 1 ? Next::ask : Next::done; next != Next::done; next = truncation.after(ends)) {
    if (next == Next::plan_apart) {
      std::vector<NearPair> within_reach;
      measure([&] { engine_->find_near(step.start, truncation.reach(), within_reach, statistics); });
      spent += statistics.seconds;
      truncation.keep_apart(within_reach);
    }
    measure([&] { engine_->find_step_ends(truncation.way(), kept, fractions.fraction, ends, statistics); });
    spent += statistics.seconds;
  }
  spent.total = watch.seconds();
  statistics.seconds = spent;
  return truncation.take();
}

void Detector::State::find_near(const Positions& positions, double distance) {
  validate_distance(distance, "the distance");
  validate(positions, mesh, "the pose");
  measure([&] { engine_->find_near(positions, {distance, radii_}, near, statistics); });
}

void Detector::State::find_intersections(const Positions& positions, Intersections wanted) {
  validate(positions, mesh, "the pose");
  measure([&] { engine_->find_intersections(positions, wanted, intersections, statistics); });
}

template <class Work>
void Detector::State::measure(const Work& work) {
  const Stopwatch watch;
  statistics = {};
  statistics.method = options.method;
  arena_.run([&] {
    statistics.threads = Arena::threads_here();
    work();
  });
  statistics.memory_bytes = memory_bytes();
  statistics.seconds.total = watch.seconds();
}

std::uint64_t Detector::State::memory_bytes() const {
  const auto of = [](const auto& part) { return part ? part->memory_bytes() : 0; };
  return engine_->memory_bytes() + sorter_.memory_bytes() + found.memory_bytes() + of(path_search_) +
         near.capacity() * sizeof(NearPair) + intersections.capacity() * sizeof(Intersection);
}

}  // namespace tamis
