#include "tamis/detector.hpp"

#include "detect/detector_state.hpp"
#include "tamis/error.hpp"

namespace tamis {

Detector::Detector(Mesh mesh, Options options) : state_(std::make_unique<State>(std::move(mesh), std::move(options))) {}
Detector::~Detector() = default;
Detector::Detector(Detector&&) noexcept = default;
Detector& Detector::operator=(Detector&&) noexcept = default;

Detector::State& Detector::state() const {
  if (!state_) throw Error("the detector has been moved from: ask the one that it went to");
  return *state_;
}

const std::vector<Contact>& Detector::contacts(const Step& step, std::optional<double> min_separation) {
  const Asked asked(*this);
  asked->ask(step, min_separation, Question::all_contacts);
  return asked->found.contacts();
}

void Detector::contacts(const Step& step, std::vector<Contact>& result, std::optional<double> min_separation) {
  const Asked asked(*this);
  asked->ask(step, min_separation, Question::all_contacts);
  result.swap(asked->found.contacts());
}

EarliestContact Detector::earliest(const Step& step, std::optional<double> min_separation) {
  return Asked(*this)->earliest(step, min_separation);
}

SafeStep Detector::keep_distance(const Step& step, double fraction, std::optional<double> min_separation) {
  return Asked(*this)->keep_distance(step, fraction, min_separation);
}

bool Detector::is_free(const Step& step, std::optional<double> min_separation) {
  const Asked asked(*this);
  asked->ask(step, min_separation, Question::is_free);
  return asked->found.contacts().empty();
}

const std::vector<NearPair>& Detector::near(const Positions& positions, double distance) {
  const Asked asked(*this);
  asked->find_near(positions, distance);
  return asked->near;
}

const std::vector<Intersection>& Detector::intersections(const Positions& positions) {
  const Asked asked(*this);
  asked->find_intersections(positions, Intersections::all);
  return asked->intersections;
}

bool Detector::has_intersection(const Positions& positions) {
  const Asked asked(*this);
  asked->find_intersections(positions, Intersections::any);
  return !asked->intersections.empty();
}

const std::vector<Contact>& Detector::contacts(const Path& path, std::optional<double> min_separation,
                                               double tolerance) {
  const Asked asked(*this);
  asked->ask(path, min_separation, tolerance, Question::all_contacts);
  return asked->found.contacts();
}

EarliestContact Detector::earliest(const Path& path, std::optional<double> min_separation, double tolerance) {
  const Asked asked(*this);
  asked->ask(path, min_separation, tolerance, Question::earliest);
  return first_of(asked->found.contacts());
}

bool Detector::is_free(const Path& path, std::optional<double> min_separation, double tolerance) {
  const Asked asked(*this);
  asked->ask(path, min_separation, tolerance, Question::is_free);
  return asked->found.contacts().empty();
}

TruncatedStep Detector::truncate(const Step& step, double fraction, std::optional<double> min_separation,
                                 Stored stored) {
  return Asked(*this)->truncate(step, fraction, min_separation, stored);
}

const Mesh& Detector::mesh() const { return state().mesh; }
const Options& Detector::options() const { return state().options; }
const Statistics& Detector::statistics() const {
  const State& now = state();
  if (now.is_asked.test(std::memory_order_acquire)) throw Busy();
  return now.statistics;
}

}  // namespace tamis
