#include "matrix/session.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>

#include "benchmarks/mean_edge.hpp"
#include "matrix/versions.hpp"
#include "scenes/point_math.hpp"
#include "tamis/error.hpp"

namespace tamis::matrix {
namespace {

constexpr double kKeptFraction = 0.2;
constexpr int kTrials = 8;
constexpr int kSubsteps = 20;

double seconds_by(clockid_t clock) {
  timespec now{};
  if (clock_gettime(clock, &now) != 0) throw InvalidOptions("this system has no clock of processor time: use --wall");
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

std::vector<Point> on_the_way(const std::vector<Point>& start, const std::vector<Point>& end, double part) {
  std::vector<Point> points = start;
  for (std::size_t v = 0; v < points.size(); ++v)
    for (std::size_t axis = 0; axis < 3; ++axis) points[v][axis] += part * (end[v][axis] - start[v][axis]);
  return points;
}

void add(std::uint64_t& hash, std::uint64_t word) { hash = (hash ^ word) * 0x100000001b3; }
void add(std::uint64_t& hash, double number) { add(hash, std::bit_cast<std::uint64_t>(number)); }

template <class Pair>
void add_pair(const Pair& pair, Outcome& outcome) {
  for (std::uint64_t* hash : {&outcome.pairs, &outcome.bits}) {
    add(*hash, static_cast<std::uint64_t>(pair.kind));
    for (const Index v : pair.vertices) add(*hash, static_cast<std::uint64_t>(v));
  }
}

void add_contact(const Contact& contact, Outcome& outcome) {
  add_pair(contact, outcome);
  for (const double number : {contact.toi_lower, contact.toi_upper, contact.u, contact.v}) add(outcome.bits, number);
  for (const double x : contact.normal) add(outcome.bits, x);
}

void add_bracket(double lower, double upper, Outcome& outcome) {
  outcome.lower.push_back(lower);
  outcome.upper.push_back(upper);
  add(outcome.bits, lower);
  add(outcome.bits, upper);
}

void add_answer(std::span<const Contact> contacts, Outcome& outcome) {
  double lower = 1, upper = 1;
  for (const Contact& contact : contacts) {
    add_contact(contact, outcome);
    lower = std::min(lower, contact.toi_lower);
    upper = std::min(upper, contact.toi_upper);
  }
  outcome.contacts += contacts.size();
  add_bracket(lower, upper, outcome);
}

void add_answer(const EarliestContact& earliest, Outcome& outcome) {
  if (earliest.contact) add(outcome.bits, std::uint64_t{1});
  outcome.contacts += earliest.contact ? 1 : 0;
  add_bracket(earliest.toi_lower, earliest.toi_upper, outcome);
}

void add_answer(bool is_free, Outcome& outcome) {
  outcome.contacts += is_free ? 0 : 1;
  add_bracket(is_free ? 1 : 0, 1, outcome);
}

void add_answer(const SafeStep& step, Outcome& outcome) {
  outcome.contacts += step.pair ? 1 : 0;
  add_bracket(step.toi_lower, step.toi_upper, outcome);
}

/// Adds a near pair, or an intersection.
template <class Found>
void add_found(const Found& found, Outcome& outcome) {
  if constexpr (requires { found.distance; }) {
    add_pair(found, outcome);
    add(outcome.bits, found.distance);
  } else {
    for (std::uint64_t* hash : {&outcome.pairs, &outcome.bits}) {
      for (const Index v : found.edge) add(*hash, static_cast<std::uint64_t>(v));
      for (const Index v : found.face) add(*hash, static_cast<std::uint64_t>(v));
    }
  }
}

/// Adds the answer of a question about positions. A template, because old versions lack the types of these answers.
template <class Answer>
void add_answer(const Answer& answer, Outcome& outcome) {
  if constexpr (requires { answer.positions; }) {
    for (const Point& point : answer.positions)
      for (const double x : point) add(outcome.bits, x);
  } else {
    for (const auto& pair : answer) add_found(pair, outcome);
    outcome.contacts += answer.size();
  }
}

void add_counts(const Statistics& statistics, Outcome& outcome) {
  outcome.counts["nodes"] += statistics.nodes_visited;
  outcome.counts["exact"] += statistics.decided_by.exact;
  for (const StageCount& stage : statistics.stages) outcome.counts[std::string(stage.name)] += pairs_of(stage);
}

}  // namespace

Session::Session(const Cell& cell, scenes::Scene scene, const Options& options, clockid_t clock)
    : cell_(cell), scene_(std::move(scene)), mesh_(scene_.mesh()), clock_(clock) {
  scene_.end = on_the_way(scene_.start, scene_.end, cell.scale);
  options_.threads = options.threads;
  options_.isa = options.isa;
  decide_all(options_);
  if (cell.scene.parts_groups) options_.filter = PairFilter::no_self_contact(scene_.group_of_vertex);
  distance_ = cell.separation * bench::mean_edge(mesh_, scene_.start);
  if (cell.question != Question::within) options_.min_separation = distance_;
  other_start_ = scenes::exchanged(scene_.start);
  other_end_ = scenes::exchanged(scene_.end);
}

void Session::ask(Question question, const std::vector<Point>& start, const std::vector<Point>& end, Outcome& outcome) {
  const Step step{start, end};
  const auto timed = [&](const auto& question_of) {
    const double before = seconds_by(clock_);
    const auto& answer = question_of();
    outcome.seconds.push_back(seconds_by(clock_) - before);
    add_answer(answer, outcome);
    add_counts(detector_->statistics(), outcome);
  };
  if (question == Question::contacts) timed([&]() -> decltype(auto) { return detector_->contacts(step); });
  if (question == Question::earliest) timed([&] { return detector_->earliest(step); });
  if (question == Question::free) timed([&] { return detector_->is_free(step); });
  if (question == Question::keep) timed([&] { return safe_step(*detector_, step, kKeptFraction); });
  ask_positions(*detector_, question, step, kKeptFraction, distance_, timed);
  if (question == Question::three)
    for (const auto one : {Question::contacts, Question::earliest, Question::free}) ask(one, start, end, outcome);
}

Outcome Session::run() {
  if (!detector_ || cell_.state == State::fresh) detector_.emplace(mesh_, options_);
  if (cell_.state != State::fresh) {
    Outcome ignored;
    ask(cell_.question, other_start_, other_end_, ignored);
  }
  Outcome outcome;
  const int parts = cell_.state == State::substeps ? kSubsteps : cell_.state == State::line ? kTrials : 1;
  std::vector<Point> start = scene_.start;
  for (int i = 0; i < parts; ++i) {
    const double part = cell_.state == State::substeps ? double(i + 1) / parts : std::ldexp(1.0, -i);
    std::vector<Point> end = part == 1 ? scene_.end : on_the_way(scene_.start, scene_.end, part);
    ask(cell_.question, start, end, outcome);
    if (cell_.state == State::substeps) start = std::move(end);
  }
  return outcome;
}

}  // namespace tamis::matrix
