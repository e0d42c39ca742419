#include "engines/tamis/pairs_ahead.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "topology/mean_edge.hpp"

namespace tamis {
namespace {

/// Steps to look ahead: more, when all that were foreseen came; fewer, where vertices stray.
constexpr double kFewestSteps = 4, kFirstSteps = 8, kMostSteps = 32;
/// Room to stray, of the mean edge: as much as nothing costs; so much that fewer steps are foreseen.
constexpr double kLeastRoom = 0x1p-12, kMostRoom = 0x1p-4;
/// Lists that serve fewer questions cost more than they save: none are made for a while, each time twice as long.
constexpr int kWorthIt = 2, kWorthAgain = 1, kFirstPause = 2, kLongestPause = 64;

/// Of a time of the way, as a float.
constexpr float kRoundedTime = 0x1p-22f;

std::vector<Index> some_of(std::span<const Index> points) {
  std::vector<Index> some;
  for (std::size_t i = 0; i < points.size(); i += 1 + points.size() / Forecast::kSample) some.push_back(points[i]);
  return some;
}

}  // namespace

PairsAhead::PairsAhead(const Mesh& mesh)
    : mesh_(mesh),
      sample_(some_of(mesh.points())),
      sample_numbers_(sample_.size()),
      steps_(kFirstSteps),
      next_pause_(kFirstPause) {
  std::iota(sample_numbers_.begin(), sample_numbers_.end(), 0);
}

Step PairsAhead::sample_of(const Step& step) {
  sample_start_.clear();
  sample_end_.clear();
  for (const Index v : sample_) {
    sample_start_.push_back({step.start[v][0], step.start[v][1], step.start[v][2]});
    sample_end_.push_back({step.end[v][0], step.end[v][1], step.end[v][2]});
  }
  return {sample_start_, sample_end_};
}

bool PairsAhead::begin(const FoundContacts& asked) {
  const Separations& separations = asked.separations();
  if (!are_listed_ || separations.fixed > separation_ || !separations.radii.empty()) return false;
  if (!is_on_way(asked.step()) || when_.t_in > until_) return false;
  // A first contact may lie within what is listed; all contacts do not.
  if (asked.question() == Question::all_contacts && !covers(when_.t_out)) return false;
  next_.make(sample_of(asked.step()), sample_numbers_, kFirstSteps);
  ++served_;
  return true;
}

bool PairsAhead::leaves_open(const FoundContacts& answered) const {
  if (covers(when_.t_out)) return false;
  if (answered.question() == Question::is_free) return answered.contacts().empty();
  const auto latest = static_cast<float>(answered.latest());
  return !covers(when_.t_in + latest * (when_.t_out - when_.t_in) + kRoundedTime);
}

bool PairsAhead::plan(const FoundContacts& asked) {
  const Step& step = asked.step();
  const Separations& separations = asked.separations();
  if (!separations.radii.empty()) return false;
  if (are_listed_) learn();
  forget();
  const Step sample = sample_of(step);
  const auto fit = next_.fit(sample, std::numeric_limits<double>::max());
  next_.make(sample, sample_numbers_, kFirstSteps);
  if (!fit) return false;
  edge_ = mean_edge(mesh_, step.start);
  starts_again_ = fit->start == 0 && fit->stray <= kLeastRoom * edge_;
  if (!(starts_again_ ? plan_again(asked.question(), kFirstSteps * fit->end) : plan_steps(asked.question(), *fit)))
    return false;
  if (pause_ > 0) {
    --pause_;
    return false;
  }
  served_ = 0;
  way_.make(step, mesh_.points(), steps_listed_);
  separation_ = separations.fixed;
  return is_on_way(step);
}

/// From the same start in the same direction, `length` times as far as the last question: what is listed is this step,
/// until its first contact where no later one is asked for. False: it is not known.
bool PairsAhead::plan_again(Question question, double length) {
  constexpr double kBeyond = 1 + 0x1p-10, kLeast = 0x1p-20;
  steps_listed_ = 1;
  room_ = kLeastRoom * edge_;
  until_ = 1;
  if (question == Question::all_contacts) return true;
  const bool seems_free = first_ >= 1 || first_ > kBeyond * length;
  if (seems_free || first_ < 0) return seems_free;
  until_ = static_cast<float>(std::min(1.0, kBeyond * first_ / length + kLeast));
  return question == Question::earliest;
}

/// Of steps that go on as the last one did.
bool PairsAhead::plan_steps(Question question, const Forecast::Fit& fit) {
  if (question == Question::is_free && first_ < 0) return false;
  steps_listed_ = steps_to_foresee(fit.stray);
  room_ = std::max(kLeastRoom * edge_, steps_listed_ * steps_listed_ * fit.stray);
  until_ = 1;
  return fit.start > 0 && steps_listed_ >= kFewestSteps;
}

void PairsAhead::end(const FoundContacts& answered) {
  first_ = answered.latest();
  if (answered.question() == Question::is_free && !answered.contacts().empty()) first_ = -1;
  if (answered.question() != Question::all_contacts) return;
  for (const Contact& contact : answered.contacts()) first_ = std::min(first_, contact.toi_upper);
}

bool PairsAhead::is_on_way(const Step& step) {
  const auto fit = way_.fit(step, room_);
  if (!fit) return false;
  when_ = {static_cast<float>(fit->start) - kRoundedTime, static_cast<float>(fit->end) + kRoundedTime};
  return true;
}

/// `stray`: after one step. It grows as the square, where something pulls or pushes.
double PairsAhead::steps_to_foresee(double stray) const {
  return std::floor(std::min(steps_, std::sqrt(kMostRoom * edge_ / stray)));
}

/// From what became of the lists.
void PairsAhead::learn() {
  if (served_ < (starts_again_ ? kWorthAgain : kWorthIt))
    pause();
  else
    next_pause_ = kFirstPause;
  if (starts_again_) return;
  const bool have_all_come = served_ + 1 >= steps_listed_;
  steps_ = have_all_come ? std::min(2 * steps_, kMostSteps) : std::max(steps_ / 2, kFewestSteps);
}

void PairsAhead::list_found(StagePipeline& pipeline) {
  for (std::size_t kind = 0; kind < kPairKinds; ++kind)
    lists_[kind].take(pipeline.candidates(static_cast<PairKind>(kind)));
}

void PairsAhead::give_up() {
  pause();
  forget();
  for (PairList& list : lists_) list = {};
}

void PairsAhead::pause() {
  pause_ = next_pause_;
  next_pause_ = std::min(2 * next_pause_, kLongestPause);
}

void PairsAhead::forget() {
  are_listed_ = false;
  way_.clear();
  for (PairList& list : lists_) list.clear();
}

std::uint64_t PairsAhead::memory_bytes() const {
  std::uint64_t bytes = next_.memory_bytes() + way_.memory_bytes() +
                        (sample_.capacity() + sample_numbers_.capacity()) * sizeof(Index) +
                        (sample_start_.capacity() + sample_end_.capacity()) * sizeof(Point);
  for (const PairList& list : lists_) bytes += list.memory_bytes();
  return bytes;
}

}  // namespace tamis
