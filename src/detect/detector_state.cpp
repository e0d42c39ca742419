#include "detect/detector_state.hpp"

#include <algorithm>

#include "detect/validate.hpp"
#include "detect/vertex_steps.hpp"
#include "engines/brute/step_length.hpp"
#include "engines/stopwatch.hpp"
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

}  // namespace

Detector::State::State(Mesh m, Options o) : mesh(std::move(m)), options(std::move(o)), arena_(options.threads) {
  validate(options, mesh);
  radii_ = radii_of(options, mesh);
  engine_ = make_engine(mesh, options);
}

Separations Detector::State::separations(std::optional<double> min_separation) const {
  if (min_separation) validate_distance(*min_separation, "the minimum separation");
  return {min_separation.value_or(options.min_separation), radii_};
}

void Detector::State::ask(const Step& step, const Separations& separations, Question question) {
  validate(step, mesh);
  measure([&] {
    found.begin(step, separations, question);
    engine_->find(found, statistics);
    if (question == Question::all_contacts) sorter_.sort(found.contacts(), mesh.vertex_count());
  });
}

void Detector::State::ask(const Path& path, const Separations& separations, double tolerance, Question question) {
  validate_tolerance(tolerance);
  measure([&] {
    if (!path_search_) path_search_ = std::make_unique<PathSearch>(mesh, options, *engine_);
    path_search_->find({path, separations, tolerance}, question, found.contacts(), statistics);
    sorter_.sort(found.contacts(), mesh.vertex_count());
  });
}

SafeStep Detector::State::keep_distance(const Step& step, const Separations& separations, double fraction) {
  SafeStep answer;
  validate(step, mesh);
  measure([&] {
    if (options.method == Method::brute) {
      answer = step_length_by_brute_force(mesh, options, step, separations, fraction, statistics);
      return;
    }
    if (!step_length_) step_length_ = std::make_unique<StepLengthSearch>(mesh, options);
    answer = step_length_->find(step, separations, fraction, statistics);
  });
  return answer;
}

VertexSteps Detector::State::vertex_steps(const Step& step, const Separations& separations, double fraction) {
  const Stopwatch watch;
  VertexSteps steps{keep_distance(step, separations, fraction).lower, {}};
  const Seconds together = statistics.seconds;
  measure([&] {
    steps.until = tamis::vertex_steps(mesh, at_rest(), near, {step, separations, steps.together}, statistics);
  });
  statistics.seconds += together;
  statistics.seconds.total = watch.seconds();
  return steps;
}

void Detector::State::find_near(const Positions& positions, double distance) {
  validate_distance(distance, "the distance");
  validate(positions, mesh, "the pose");
  measure([&] { at_rest().find_near(positions, {distance, radii_}, near, statistics); });
}

void Detector::State::find_intersections(const Positions& positions, Intersections wanted) {
  validate(positions, mesh, "the pose");
  measure([&] { at_rest().find_intersections(positions, wanted, intersections, statistics); });
}

RestEngine& Detector::State::at_rest() {
  if (RestEngine* own = engine_->at_rest()) return *own;
  if (!rest_engine_) rest_engine_ = make_tamis_engine(mesh, options);
  return *rest_engine_->at_rest();
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
  return engine_->memory_bytes() + sorter_.memory_bytes() + found.memory_bytes() + of(step_length_) + of(path_search_) +
         of(rest_engine_) + near.capacity() * sizeof(NearPair) + intersections.capacity() * sizeof(Intersection);
}

}  // namespace tamis
