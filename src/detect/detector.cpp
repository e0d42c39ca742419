#include "tamis/detector.hpp"

#include "detect/detector_state.hpp"
#include "detect/truncation.hpp"
#include "detect/validate.hpp"
#include "engines/pair_rules.hpp"
#include "engines/stopwatch.hpp"
#include "solve/start_distance.hpp"
#include "tamis/error.hpp"

namespace tamis {
namespace {

void validate_kept_part(double fraction) {
  if (!(fraction > 0 && fraction < 1))
    throw InvalidOptions("the fraction of the distance to keep is " + std::to_string(fraction) +
                         ": give a number > 0 and < 1");
}

}  // namespace

Detector::Detector(Mesh mesh, Options options) : state_(std::make_unique<State>(std::move(mesh), std::move(options))) {}
Detector::~Detector() = default;
Detector::Detector(Detector&&) noexcept = default;
Detector& Detector::operator=(Detector&&) noexcept = default;

const std::vector<Contact>& Detector::contacts(const Step& step, std::optional<double> min_separation) {
  state_->ask(step, state_->separations(min_separation), Question::all_contacts);
  return state_->found.contacts();
}

void Detector::contacts(const Step& step, std::vector<Contact>& result, std::optional<double> min_separation) {
  contacts(step, min_separation);
  result.swap(state_->found.contacts());
}

EarliestContact Detector::earliest(const Step& step, std::optional<double> min_separation) {
  state_->ask(step, state_->separations(min_separation), Question::earliest);
  const EarliestContact first = state_->found.first();
  state_->statistics.decided_by += state_->found.decided_by();
  return first;
}

SafeStep Detector::keep_distance(const Step& step, double fraction, std::optional<double> min_separation) {
  validate_kept(fraction);
  if (fraction > 0) return state_->keep_distance(step, state_->separations(min_separation), fraction);
  const EarliestContact first = earliest(step, min_separation);
  if (!first.contact) return {};
  const Contact& c = *first.contact;
  const double distance = start_distance(c.kind, points_of(step, c.vertices));
  return {first.toi_lower, first.toi_upper, LimitingPair{c.kind, c.vertices, distance}};
}

bool Detector::is_free(const Step& step, std::optional<double> min_separation) {
  state_->ask(step, state_->separations(min_separation), Question::is_free);
  return state_->found.contacts().empty();
}

const std::vector<NearPair>& Detector::near(const Positions& positions, double distance) {
  state_->find_near(positions, distance);
  return state_->near;
}

const std::vector<Intersection>& Detector::intersections(const Positions& positions) {
  state_->find_intersections(positions, Intersections::all);
  return state_->intersections;
}

bool Detector::has_intersection(const Positions& positions) {
  state_->find_intersections(positions, Intersections::any);
  return !state_->intersections.empty();
}

const std::vector<Contact>& Detector::contacts(const Path& path, std::optional<double> min_separation,
                                               double tolerance) {
  state_->ask(path, state_->separations(min_separation), tolerance, Question::all_contacts);
  return state_->found.contacts();
}

EarliestContact Detector::earliest(const Path& path, std::optional<double> min_separation, double tolerance) {
  state_->ask(path, state_->separations(min_separation), tolerance, Question::earliest);
  return first_of(state_->found.contacts());
}

bool Detector::is_free(const Path& path, std::optional<double> min_separation, double tolerance) {
  state_->ask(path, state_->separations(min_separation), tolerance, Question::is_free);
  return state_->found.contacts().empty();
}

VertexSteps Detector::vertex_steps(const Step& step, double fraction, std::optional<double> min_separation) {
  validate_kept_part(fraction);
  return state_->vertex_steps(step, state_->separations(min_separation), fraction);
}

TruncatedStep Detector::truncate(const Step& step, double fraction, std::optional<double> min_separation) {
  validate_kept_part(fraction);
  const Stopwatch watch;
  Truncation truncation(step, vertex_steps(step, fraction, min_separation));
  Seconds spent = state_->statistics.seconds;
  do {
    truncation.pull_back(contacts(truncation.way(), min_separation));
    spent += state_->statistics.seconds;
  } while (truncation.goes_on());
  spent.total = watch.seconds();
  state_->statistics.seconds = spent;
  return truncation.take();
}

const Mesh& Detector::mesh() const { return state_->mesh; }
const Options& Detector::options() const { return state_->options; }
const Statistics& Detector::statistics() const { return state_->statistics; }

}  // namespace tamis
