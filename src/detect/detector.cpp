#include "tamis/detector.hpp"

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>

#include "detect/contact_order.hpp"
#include "detect/validate.hpp"
#include "engines/brute/step_length.hpp"
#include "engines/engine.hpp"
#include "engines/pair_rules.hpp"
#include "engines/tamis/step_length.hpp"
#include "solve/decide.hpp"
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

/// The contact as decided on the whole step: the last bits of what the engine found depend on how far it still had to
/// look, and so on earlier questions.
Contact decided_anew(const Contact& c, const Step& step, const Options& options, PrecisionCount& decided_by) {
  const PairPoints points = points_of(step, c.vertices);
  const auto r = decide(c.kind, points, {options.guarantee, options.min_separation}, decided_by);
  Contact contact =
      r.touches ? Contact{c.kind, r.certainty, c.vertices, r.toi_lower, r.toi_upper, r.u, r.v, r.normal} : c;
  // Decided exactly, so that a line search never stops for nothing.
  if (contact.toi_lower == 0 && contact.toi_upper > 0)
    contact.toi_lower = std::min(apart_from_start(c.kind, points, options.min_separation), contact.toi_upper);
  return contact;
}

/// The step must stop at the smallest lower end; certified contacts give the smallest upper end.
EarliestContact first_of(const std::vector<Contact>& contacts, const Step& step, const Options& options,
                         PrecisionCount& decided_by) {
  double last = 1;
  for (const Contact& c : contacts)
    if (c.certainty == Certainty::certified) last = std::min(last, c.toi_upper * kNearTie);
  EarliestContact first;
  for (const Contact& found : contacts) {
    if (found.toi_lower > last) continue;
    const Contact c = decided_anew(found, step, options, decided_by);
    if (c.certainty == Certainty::certified) first.toi_upper = std::min(first.toi_upper, c.toi_upper);
    const bool is_earlier = !first.contact || c.toi_lower < first.toi_lower ||
                            (c.toi_lower == first.toi_lower && comes_before(c, *first.contact));
    if (!is_earlier) continue;
    first.toi_lower = c.toi_lower;
    first.contact = c;
  }
  return first;
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
      contacts.clear();
      engine->find(step, question, contacts, statistics);
      if (question == Question::all_contacts) sorter.sort(contacts, mesh.vertex_count());
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
    statistics.memory_bytes = engine->memory_bytes() + sorter.memory_bytes() + contacts.capacity() * sizeof(Contact) +
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
  std::vector<Contact> contacts;
  ContactSorter sorter;
  Statistics statistics;
};

Detector::Detector(Mesh mesh, Options options) : state_(std::make_unique<State>(std::move(mesh), std::move(options))) {}
Detector::~Detector() = default;
Detector::Detector(Detector&&) noexcept = default;
Detector& Detector::operator=(Detector&&) noexcept = default;

const std::vector<Contact>& Detector::contacts(const Step& step) {
  state_->ask(step, Question::all_contacts);
  return state_->contacts;
}

void Detector::contacts(const Step& step, std::vector<Contact>& result) {
  state_->ask(step, Question::all_contacts);
  result.swap(state_->contacts);
}

EarliestContact Detector::earliest(const Step& step) {
  state_->ask(step, Question::earliest);
  return first_of(state_->contacts, step, state_->options, state_->statistics.decided_by);
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
  const double upper = first.toi_lower == 0 ? 0 : first.toi_upper;  // 0 has been decided exactly
  return {first.toi_lower, upper, LimitingPair{c.kind, c.vertices, distance}};
}

bool Detector::is_free(const Step& step) {
  state_->ask(step, Question::is_free);
  return state_->contacts.empty();
}

const Mesh& Detector::mesh() const { return state_->mesh; }
const Options& Detector::options() const { return state_->options; }
const Statistics& Detector::statistics() const { return state_->statistics; }

}  // namespace tamis
