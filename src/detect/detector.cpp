#include "tamis/detector.hpp"

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <chrono>

#include "detect/contact_order.hpp"
#include "detect/validate.hpp"
#include "engines/brute/step_length.hpp"
#include "engines/engine.hpp"
#include "engines/pair_rules.hpp"
#include "engines/tamis/step_length.hpp"
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

}  // namespace

struct Detector::State {
  State(Mesh m, Options o) : mesh(std::move(m)), options(std::move(o)) {
    validate(options, mesh);
    engine = make_engine(mesh, options);
    if (options.threads > 0) arena.initialize(options.threads);
  }

  void ask(const Step& step, Question question) {
    measure(step, [&] {
      found.begin(step, question);
      engine->find(found, statistics);
      if (question == Question::all_contacts) sorter.sort(found.contacts(), mesh.vertex_count());
    });
  }

  SafeStep keep_distance(const Step& step, double fraction) {
    SafeStep answer;
    measure(step, [&] {
      if (options.method == Method::brute) {
        answer = step_length_by_brute_force(mesh, options, step, fraction, statistics);
        return;
      }
      if (!step_length) step_length = std::make_unique<StepLengthSearch>(mesh, options);
      answer = step_length->find(step, fraction, statistics);
    });
    return answer;
  }

  /// Runs `work` in the arena, with fresh statistics.
  template <class Work>
  void measure(const Step& step, const Work& work) {
    validate(step, mesh);
    const auto start = std::chrono::steady_clock::now();
    statistics = {};
    statistics.method = options.method;
    in_arena([&] {
      statistics.threads = tbb::this_task_arena::max_concurrency();
      work();
    });
    statistics.memory_bytes = engine->memory_bytes() + sorter.memory_bytes() + found.memory_bytes() +
                              (step_length ? step_length->memory_bytes() : 0);
    statistics.seconds.total = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }

  template <class F>
  void in_arena(const F& f) {
    if (options.threads > 0)
      arena.execute(f);
    else
      f();
  }

  Mesh mesh;
  Options options;
  tbb::task_arena arena;
  std::unique_ptr<Engine> engine;
  std::unique_ptr<StepLengthSearch> step_length;  ///< made by the first question that needs it
  FoundContacts found{options};
  ContactSorter sorter;
  Statistics statistics;
};

Detector::Detector(Mesh mesh, Options options) : state_(std::make_unique<State>(std::move(mesh), std::move(options))) {}
Detector::~Detector() = default;
Detector::Detector(Detector&&) noexcept = default;
Detector& Detector::operator=(Detector&&) noexcept = default;

const std::vector<Contact>& Detector::contacts(const Step& step) {
  state_->ask(step, Question::all_contacts);
  return state_->found.contacts();
}

void Detector::contacts(const Step& step, std::vector<Contact>& result) {
  state_->ask(step, Question::all_contacts);
  result.swap(state_->found.contacts());
}

EarliestContact Detector::earliest(const Step& step) {
  state_->ask(step, Question::earliest);
  const EarliestContact first = state_->found.first();
  state_->statistics.decided_by += state_->found.decided_by();
  return first;
}

SafeStep Detector::keep_distance(const Step& step, double fraction) {
  if (!(fraction >= 0 && fraction < 1))
    throw InvalidOptions("the fraction of the distance to keep is " + std::to_string(fraction) +
                         ": give a number >= 0 and < 1");
  if (fraction > 0) return state_->keep_distance(step, fraction);
  const EarliestContact first = earliest(step);
  if (!first.contact) return {};
  const Contact& c = *first.contact;
  const double distance = start_distance(c.kind, points_of(step, c.vertices));
  return {first.toi_lower, first.toi_upper, LimitingPair{c.kind, c.vertices, distance}};
}

bool Detector::is_free(const Step& step) {
  state_->ask(step, Question::is_free);
  return state_->found.contacts().empty();
}

const Mesh& Detector::mesh() const { return state_->mesh; }
const Options& Detector::options() const { return state_->options; }
const Statistics& Detector::statistics() const { return state_->statistics; }

}  // namespace tamis
