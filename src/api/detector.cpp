#include "tamis/detector.hpp"

#include "api/detector_state.hpp"
#include "tamis/error.hpp"

namespace tamis {

Detector::Detector(Mesh mesh, Options options)
    : Detector(DetectorAccess::make(std::move(mesh), std::move(options), make_tamis_engine)) {}
Detector::Detector(std::unique_ptr<State> state) : state_(std::move(state)) {}
Detector::~Detector() = default;
Detector::Detector(Detector&&) noexcept = default;
Detector& Detector::operator=(Detector&&) noexcept = default;

Detector::State& Detector::state() const {
  if (!state_) throw Error("the detector has been moved from: use the detector that it was moved to");
  return *state_;
}

std::span<const Contact> Detector::contacts(const Step& step, const QueryOptions& options) & {
  return LockedState(*this)->find_contacts(step, options);
}

EarliestContact Detector::earliest(const Step& step, const QueryOptions& options) {
  return LockedState(*this)->earliest(step, options);
}

SafeStep Detector::safe_step(const Step& step, double keep, const QueryOptions& options) {
  return LockedState(*this)->safe_step(step, keep, options);
}

bool Detector::is_free(const Step& step, const QueryOptions& options) {
  return LockedState(*this)->is_free(step, options);
}

std::span<const NearPair> Detector::pairs_within(const Positions& positions, double distance) & {
  return LockedState(*this)->find_near(positions, distance);
}

std::span<const Intersection> Detector::intersections(const Positions& positions) & {
  return LockedState(*this)->find_intersections(positions, Question::all_contacts);
}

bool Detector::has_intersection(const Positions& positions) {
  return !LockedState(*this)->find_intersections(positions, Question::is_free).empty();
}

std::span<const Contact> Detector::contacts(const Path& path, const PathOptions& options) & {
  return LockedState(*this)->find_contacts(CutPath{path}, options);
}

EarliestContact Detector::earliest(const Path& path, const PathOptions& options) {
  return LockedState(*this)->earliest(CutPath{path}, options);
}

bool Detector::is_free(const Path& path, const PathOptions& options) {
  return LockedState(*this)->is_free(CutPath{path}, options);
}

TruncatedStep Detector::truncate(const Step& step, double keep, const QueryOptions& options, StoredType stored) {
  return LockedState(*this)->truncate(step, keep, options, stored);
}

const Mesh& Detector::mesh() const { return state().mesh; }
const Options& Detector::options() const { return state().options; }
const Statistics& Detector::statistics() const {
  const State& now = state();
  if (now.is_asked.test(std::memory_order_acquire)) throw Busy();
  return now.statistics;
}

Detector DetectorAccess::make(Mesh mesh, Options options, const MakeEngine& make_engine) {
  const ComputingState computing;
  return Detector(std::make_unique<Detector::State>(std::move(mesh), std::move(options), make_engine));
}

Detector::LockedState DetectorAccess::lock(const Detector& detector) { return Detector::LockedState(detector); }

void DetectorAccess::use_frame(Detector& detector, const BoxFrame& of_scene) { lock(detector)->use_frame(of_scene); }

}  // namespace tamis
