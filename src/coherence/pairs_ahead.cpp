#include "coherence/pairs_ahead.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "topology/mean_edge.hpp"

namespace tamis {
namespace {

/// Steps to look ahead: more when all predicted ones came, fewer where vertices deviate.
constexpr double kFewestSteps = 4, kFirstSteps = 8, kMostSteps = 32;
/// Slack, in mean edges: the least, which costs nothing; the most, beyond which fewer steps are predicted.
constexpr double kLeastSlackInEdges = 0x1p-12, kMostSlackInEdges = 0x1p-4;
/// After one step: with more the fewest steps need more than the most slack.
constexpr double kMostDeviationInEdges = kMostSlackInEdges / (kFewestSteps * kFewestSteps);
/// Lists that serve fewer queries cost more than they save.
constexpr int kQueriesWorthLists = 2, kQueriesWorthListsOfOneStep = 1;
/// A step that is not free is found to be so by a fraction of what lists cost, and often no later one is free.
constexpr int kFreeWorthLists = 2;
constexpr int kFirstPauseInQueries = 2;

/// Rounding of a time of the predicted step to float.
constexpr float kTimeRounding = 0x1p-22f;

std::vector<Index> some_of(std::span<const Index> points) {
  std::vector<Index> some;
  for (std::size_t i = 0; i < points.size(); i += 1 + points.size() / Forecast::kSampleVertices)
    some.push_back(points[i]);
  return some;
}

}  // namespace

PairsAhead::PairsAhead(const Mesh& mesh)
    : mesh_(mesh), sample_(some_of(mesh.points())), steps_(kFirstSteps), pause_{kFirstPauseInQueries} {}

bool PairsAhead::begin(const Query& query) {
  if (!are_listed_ || query.is_piece || query.separations.fixed > separation_) return false;
  if (!follows_prediction(query.step) || when_.t_in > until_) return false;
  // A first contact may lie within what is listed; all contacts do not.
  if (query.question == Question::all_contacts && !covers(when_.t_out)) return false;
  next_.make(query.step, sample_, kFirstSteps);
  ++queries_served_;
  return true;
}

bool PairsAhead::leaves_undecided(const ContactCollector& answer) const {
  if (covers(when_.t_out)) return false;
  if (answer.query().question == Question::is_free) return answer.contacts().empty();
  const auto latest = static_cast<float>(answer.bound().latest());
  return !covers(when_.t_in + latest * (when_.t_out - when_.t_in) + kTimeRounding);
}

bool PairsAhead::plan(const Query& query) {
  if (query.is_piece) return false;
  const Step& step = query.step;
  if (are_listed_) learn();
  forget();
  std::optional<Forecast::Fit> fit;
  if (next_.is_made()) {
    edge_ = mean_edge(mesh_, step.start);
    fit = next_.fit(step, kMostDeviationInEdges * edge_);
  }
  next_.make(step, sample_, kFirstSteps);
  if (!fit) return false;
  starts_again_ = fit->start == 0 && fit->deviation <= kLeastSlackInEdges * edge_;
  const bool is_promising =
      starts_again_ ? plan_again(query.question, kFirstSteps * fit->end) : plan_steps(query.question, *fit);
  if (!is_promising) return false;
  if (pause_.left > 0) {
    pause_.tick();
    return false;
  }
  queries_served_ = 0;
  predicted_.make(step, mesh_.points(), steps_listed_);
  separation_ = query.separations.fixed;
  return follows_prediction(step);
}

/// From the same start in the same direction, `length` times as far as the last query. The lists are for this step,
/// until its first contact where no later one is asked for. False: that contact is not known.
bool PairsAhead::plan_again(Question question, double length) {
  constexpr double kBeyond = 1 + 0x1p-10, kLeast = 0x1p-20;
  steps_listed_ = 1;
  slack_ = kLeastSlackInEdges * edge_;
  until_ = 1;
  if (question == Question::all_contacts) return true;
  if (!no_contact_before_) return false;
  if (*no_contact_before_ >= 1 || *no_contact_before_ > kBeyond * length) return true;
  until_ = static_cast<float>(std::min(1.0, kBeyond * *no_contact_before_ / length + kLeast));
  return question == Question::earliest;
}

/// Of steps that go on as the last one did.
bool PairsAhead::plan_steps(Question question, const Forecast::Fit& fit) {
  if (question == Question::is_free && free_in_row_ < kFreeWorthLists) return false;
  steps_listed_ = steps_to_foresee(fit.deviation);
  slack_ = std::max(kLeastSlackInEdges * edge_, steps_listed_ * steps_listed_ * fit.deviation);
  until_ = 1;
  return fit.start > 0 && steps_listed_ >= kFewestSteps;
}

void PairsAhead::end(const ContactCollector& answer, const SearchWork& work) {
  if (answer.query().is_piece) return;
  const Question question = answer.query().question;
  no_contact_before_ = answer.bound().latest();
  if (question == Question::all_contacts) no_contact_before_ = std::min(*no_contact_before_, answer.touched_by());
  if (question == Question::is_free && !answer.contacts().empty()) no_contact_before_.reset();
  free_in_row_ = no_contact_before_ && *no_contact_before_ >= 1 ? free_in_row_ + 1 : 0;
  const bool ended_early = question == Question::is_free && !answer.contacts().empty();  // at once, or by chance later
  if (!are_listed_ && !ended_early) last_search_ = work;
}

bool PairsAhead::follows_prediction(const Step& step) {
  const auto fit = predicted_.fit(step, slack_);
  if (!fit) return false;
  when_ = {static_cast<float>(fit->start) - kTimeRounding, static_cast<float>(fit->end) + kTimeRounding};
  return true;
}

/// `deviation`: after one step. It grows as the square of the steps, where something pulls or pushes.
double PairsAhead::steps_to_foresee(double deviation) const {
  return std::floor(std::min(steps_, std::sqrt(kMostSlackInEdges * edge_ / deviation)));
}

/// From what became of the lists.
void PairsAhead::learn() {
  if (queries_served_ < (starts_again_ ? kQueriesWorthListsOfOneStep : kQueriesWorthLists))
    pause_.begin();
  else
    pause_.lists_were_worth_it();
  if (starts_again_) return;
  const bool have_all_come = queries_served_ + 1 >= steps_listed_;
  steps_ = have_all_come ? std::min(2 * steps_, kMostSteps) : std::max(steps_ / 2, kFewestSteps);
}

/// is_free: that of as many searches as are known to have ended nowhere, so that lists cost no more than twice what is
/// best in hindsight; more where more steps are foreseen, since all of those before came. The others are asked of every
/// step to its end, and lists that cost several of their searches have paid (docs/history/performance.md, "Lists that
/// cost too much").
std::uint64_t PairsAhead::most_work(Question question) const {
  if (question != Question::is_free) return std::numeric_limits<std::uint64_t>::max();
  const auto searches = std::max<std::uint64_t>(kFreeWorthLists, static_cast<std::uint64_t>(steps_listed_) / 4);
  return (searches - 1) * last_search_.trees + searches * last_search_.pairs;
}

bool PairsAhead::complete(bool hold_all) {
  are_listed_ = hold_all;
  if (hold_all) return true;
  steps_ = std::max(steps_ / 2, kFewestSteps);
  pause_.begin();
  forget();
  lists_ = {};
  return false;
}

void PairsAhead::forget() {
  are_listed_ = false;
  predicted_.clear();
  lists_.clear();
}

}  // namespace tamis
