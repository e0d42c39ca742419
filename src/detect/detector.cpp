#include "tamis/detector.hpp"

#include <algorithm>
#include <chrono>

#include "detect/arena.hpp"
#include "detect/contact_order.hpp"
#include "detect/truncation.hpp"
#include "detect/validate.hpp"
#include "detect/vertex_steps.hpp"
#include "engines/brute/step_length.hpp"
#include "engines/engine.hpp"
#include "engines/pair_rules.hpp"
#include "engines/rest_engine.hpp"
#include "engines/tamis/intersection_search.hpp"
#include "engines/tamis/step_length.hpp"
#include "paths/path_search.hpp"
#include "solve/kept_distance.hpp"
#include "solve/start_distance.hpp"
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
  for (std::size_t v = 0; v < group.size(); ++v) radii[v] = options.thickness[static_cast<std::size_t>(group[v])];
  return radii;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

struct Detector::State {
  State(Mesh m, Options o) : mesh(std::move(m)), options(std::move(o)), arena(options.threads) {
    validate(options, mesh);
    radii = radii_of(options, mesh);
    engine = make_engine(mesh, options);
  }

  Separations separations(std::optional<double> min_separation) const {
    if (min_separation) validate_distance(*min_separation, "the minimum separation");
    return {min_separation.value_or(options.min_separation), radii};
  }

  void ask(const Step& step, const Separations& separations, Question question) {
    validate(step, mesh);
    measure([&] {
      found.begin(step, separations, question);
      engine->find(found, statistics);
      if (question == Question::all_contacts) sorter.sort(found.contacts(), mesh.vertex_count());
    });
  }

  /// The contacts are in `found`.
  void ask(const Path& path, const Separations& separations, double tolerance, Question question) {
    validate_tolerance(tolerance);
    measure([&] {
      if (!path_search) path_search = std::make_unique<PathSearch>(mesh, options, *engine);
      path_search->find({path, separations, tolerance}, question, found.contacts(), statistics);
      sorter.sort(found.contacts(), mesh.vertex_count());
    });
  }

  SafeStep keep_distance(const Step& step, const Separations& separations, double fraction) {
    SafeStep answer;
    validate(step, mesh);
    measure([&] {
      if (options.method == Method::brute) {
        answer = step_length_by_brute_force(mesh, options, step, separations, fraction, statistics);
        return;
      }
      if (!step_length) step_length = std::make_unique<StepLengthSearch>(mesh, options);
      answer = step_length->find(step, separations, fraction, statistics);
    });
    return answer;
  }

  void find_near(const Positions& positions, double distance) {
    validate_distance(distance, "the distance");
    validate(positions, mesh, "the pose");
    measure([&] { at_rest().find_near(positions, {distance, radii}, near, statistics); });
  }

  void find_intersections(const Positions& positions, Intersections wanted) {
    validate(positions, mesh, "the pose");
    measure([&] {
      if (!intersection_search) intersection_search = std::make_unique<IntersectionSearch>(mesh, options);
      intersection_search->find(positions, wanted, intersections, statistics);
    });
  }

  RestEngine& at_rest() {
    if (RestEngine* own = engine->at_rest()) return *own;
    if (!rest_engine) rest_engine = make_tamis_engine(mesh, options);
    return *rest_engine->at_rest();
  }

  VertexSteps vertex_steps(const Step& step, const Separations& separations, double fraction) {
    const auto start = std::chrono::steady_clock::now();
    VertexSteps steps{keep_distance(step, separations, fraction).lower, {}};
    measure([&] {
      steps.until = tamis::vertex_steps(mesh, at_rest(), near, {step, separations, steps.together}, statistics);
    });
    statistics.seconds.total = seconds_since(start);
    return steps;
  }

  /// Runs `work` in the arena, with fresh statistics.
  template <class Work>
  void measure(const Work& work) {
    const auto start = std::chrono::steady_clock::now();
    statistics = {};
    statistics.method = options.method;
    arena.run([&] {
      statistics.threads = Arena::threads_here();
      work();
    });
    statistics.memory_bytes = engine->memory_bytes() + sorter.memory_bytes() + found.memory_bytes() +
                              (step_length ? step_length->memory_bytes() : 0) +
                              (path_search ? path_search->memory_bytes() : 0) +
                              (rest_engine ? rest_engine->memory_bytes() : 0) + near.capacity() * sizeof(NearPair) +
                              (intersection_search ? intersection_search->memory_bytes() : 0) +
                              intersections.capacity() * sizeof(Intersection);
    statistics.seconds.total = seconds_since(start);
  }

  Mesh mesh;
  Options options;
  std::vector<double> radii;  ///< of the vertices; empty: all zero
  Arena arena;
  std::unique_ptr<Engine> engine;
  std::unique_ptr<StepLengthSearch> step_length;  ///< made by the first question that needs it, as what follows
  std::unique_ptr<Engine> rest_engine;            ///< where `engine` does not answer at rest
  std::unique_ptr<PathSearch> path_search;
  FoundContacts found{options};
  std::vector<NearPair> near;
  std::unique_ptr<IntersectionSearch> intersection_search;  ///< likewise
  std::vector<Intersection> intersections;
  ContactSorter sorter;
  Statistics statistics;
};

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

namespace {

void validate_kept_part(double fraction) {
  if (!(fraction > 0 && fraction < 1))
    throw InvalidOptions("the fraction of the distance to keep is " + std::to_string(fraction) +
                         ": give a number > 0 and < 1");
}

}  // namespace

VertexSteps Detector::vertex_steps(const Step& step, double fraction, std::optional<double> min_separation) {
  validate_kept_part(fraction);
  return state_->vertex_steps(step, state_->separations(min_separation), fraction);
}

TruncatedStep Detector::truncate(const Step& step, double fraction, std::optional<double> min_separation) {
  validate_kept_part(fraction);
  const auto start = std::chrono::steady_clock::now();
  Truncation truncation(step, vertex_steps(step, fraction, min_separation));
  do {
    truncation.pull_back(contacts(truncation.way(), min_separation));
  } while (truncation.goes_on());
  state_->statistics.seconds.total = seconds_since(start);
  return truncation.take();
}

const Mesh& Detector::mesh() const { return state_->mesh; }
const Options& Detector::options() const { return state_->options; }
const Statistics& Detector::statistics() const { return state_->statistics; }

}  // namespace tamis
