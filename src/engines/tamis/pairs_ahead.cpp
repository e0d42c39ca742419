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
/// Room to stray, of the mean edge: as much as nothing costs, and where lists become too long.
constexpr double kLeastRoom = 0x1p-12, kMostRoom = 0x1p-4;
/// Lists that serve fewer questions cost more than they save: none are made for a while, each time twice as long.
constexpr int kWorthIt = 2, kFirstPause = 2, kLongestPause = 64;

std::vector<Index> some_of(std::span<const Index> points) {
  constexpr std::size_t kSample = 512;
  std::vector<Index> some;
  for (std::size_t i = 0; i < points.size(); i += 1 + points.size() / kSample) some.push_back(points[i]);
  return some;
}

}  // namespace

PairsAhead::PairsAhead(const Mesh& mesh, const Options& options)
    : mesh_(mesh),
      options_(options),
      some_(some_of(mesh.points())),
      places_(some_.size()),
      steps_(kFirstSteps),
      next_pause_(kFirstPause) {
  std::iota(places_.begin(), places_.end(), 0);
}

Step PairsAhead::sample_of(const Step& step) {
  some_start_.clear();
  some_end_.clear();
  for (const Index v : some_) {
    some_start_.push_back({step.start[v][0], step.start[v][1], step.start[v][2]});
    some_end_.push_back({step.end[v][0], step.end[v][1], step.end[v][2]});
  }
  return {some_start_, some_end_};
}

bool PairsAhead::covers(const FoundContacts& asked) {
  const Separations& separations = asked.separations();
  if (!are_listed_ || separations.fixed > separation_ || !separations.radii.empty()) return false;
  if (!is_on_way(asked.step())) return false;
  next_.make(sample_of(asked.step()), places_, kFirstSteps);
  ++served_;
  return true;
}

bool PairsAhead::promises(const FoundContacts& asked) {
  const Step& step = asked.step();
  const Separations& separations = asked.separations();
  if (options_.guarantee != Guarantee::exact || !separations.radii.empty()) return false;
  if (are_listed_) learn();
  forget();
  constexpr double kAnywhere = std::numeric_limits<double>::max();
  const Step sample = sample_of(step);
  const Forecast::Fit fit = next_.is_made() ? next_.fit(sample, kAnywhere) : Forecast::Fit{0, 0, kAnywhere};
  next_.make(sample, places_, kFirstSteps);
  if (fit.start == 0 || (asked.question() == Question::is_free && is_soon_touching_)) return false;
  if (edge_ == 0) edge_ = mean_edge(mesh_, step.start);
  const double steps = steps_to_foresee(fit.stray);
  if (!(steps >= kFewestSteps)) return false;
  if (pause_ > 0) return --pause_, false;
  edge_ = mean_edge(mesh_, step.start);
  steps_listed_ = steps;
  served_ = 0;
  window_.make(step, mesh_.points(), steps);
  room_ = std::max(kLeastRoom * edge_, steps * steps * fit.stray);
  separation_ = separations.fixed;
  return is_on_way(step);
}

void PairsAhead::end(const FoundContacts& answered) {
  if (answered.question() == Question::is_free) is_soon_touching_ = !answered.contacts().empty();
}

bool PairsAhead::is_on_way(const Step& step) {
  const Forecast::Fit fit = window_.fit(step, room_);
  constexpr float kRoundedTime = 0x1p-22f;
  when_ = {static_cast<float>(fit.start) - kRoundedTime, static_cast<float>(fit.end) + kRoundedTime};
  return fit.stray <= room_;
}

/// `stray`: after one step. It grows as the square, where something pulls or pushes.
double PairsAhead::steps_to_foresee(double stray) const {
  return std::floor(std::min(steps_, std::sqrt(kMostRoom * edge_ / stray)));
}

/// From what became of the lists.
void PairsAhead::learn() {
  if (served_ < kWorthIt)
    pause();
  else
    next_pause_ = kFirstPause;
  const bool have_all_come = served_ + 1 >= steps_listed_;
  steps_ = have_all_come ? std::min(2 * steps_, kMostSteps) : std::max(steps_ / 2, kFewestSteps);
}

void PairsAhead::take(StagePipeline& pipeline) {
  for (std::size_t kind = 0; kind < kPairKinds; ++kind)
    lists_[kind].take(pipeline.candidates(static_cast<PairKind>(kind)));
}

bool PairsAhead::has_room(int leaf_blocks) {
  std::size_t pairs = 0;
  for (const PairList& list : lists_) pairs += list.size();
  if (pairs <= kMostListed * static_cast<std::size_t>(leaf_blocks)) return true;
  pause();
  forget();
  return false;
}

void PairsAhead::pause() {
  pause_ = next_pause_;
  next_pause_ = std::min(2 * next_pause_, kLongestPause);
}

void PairsAhead::forget() {
  are_listed_ = false;
  window_.clear();
  for (PairList& list : lists_) list.clear();
}

std::uint64_t PairsAhead::memory_bytes() const {
  std::uint64_t bytes = next_.memory_bytes() + window_.memory_bytes() +
                        (some_.capacity() + places_.capacity()) * sizeof(Index) +
                        (some_start_.capacity() + some_end_.capacity()) * sizeof(Point);
  for (const PairList& list : lists_) bytes += list.memory_bytes();
  return bytes;
}

}  // namespace tamis
