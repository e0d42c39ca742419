#include "search/coherence/pairs_ahead.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "search/topology/mean_edge.hpp"

namespace tamis {
namespace {

/// How many steps to predict, at least and at most.
constexpr double kFewestSteps = 4, kMostSteps = 16;
/// Slack in mean edges: the least, which costs nothing, and the most, which limits how many steps are predicted.
constexpr double kLeastSlackInEdges = 0x1p-12, kMostSlackInEdges = 0x1p-4;
/// The largest deviation after one step that lets kFewestSteps need no more than the most slack.
constexpr double kMostDeviationInEdges = kMostSlackInEdges / (kFewestSteps * kFewestSteps);
/// Queries that lists must serve to be worth their cost.
constexpr int kQueriesWorthLists = 2, kQueriesWorthListsOfOneStep = 1;
constexpr int kFirstPauseInQueries = 2;

/// Rounding of a time of the predicted step to float.
constexpr float kTimeRounding = 0x1p-22f;

std::vector<Index> some_of(std::span<const Index> points) {
  std::vector<Index> some;
  for (std::size_t i = 0; i < points.size(); i += 1 + points.size() / PredictedStep::kSampleVertices)
    some.push_back(points[i]);
  return some;
}

}  // namespace

PairsAhead::PairsAhead(const Mesh& mesh)
    : KeptLists({kFirstPauseInQueries}), mesh_(mesh), sample_(some_of(mesh.points())) {}

bool PairsAhead::begin(const Query& query) {
  if (!are_listed_ || query.is_piece || query.separations.fixed > separation_) return false;
  if (!follows_prediction(query.step) || when_.t_in > listed_until_) return false;
  // A first contact may lie within the times listed. All contacts need the whole step listed.
  if (query.question == Question::all_contacts && !covers(when_.t_out)) return false;
  next_.make(query.step, sample_, kMostSteps);
  ++queries_served_;
  return true;
}

bool PairsAhead::leaves_undecided(const ContactCollector& answer) const {
  if (covers(when_.t_out)) return false;
  if (answer.query().question == Question::is_free) return answer.contacts().empty();
  const auto latest = static_cast<float>(answer.bound().latest());
  return !covers(when_.t_in + latest * (when_.t_out - when_.t_in) + kTimeRounding);
}

std::optional<Listing> PairsAhead::plan(const Query& query) {
  if (query.is_piece) return {};
  const Step& step = query.step;
  const bool were_worth_it = queries_served_ >= (same_start_ ? kQueriesWorthListsOfOneStep : kQueriesWorthLists);
  if (are_listed_ && were_worth_it) pause_.lists_were_worth_it();
  if (are_listed_ && !were_worth_it) pause_.begin();
  forget();
  std::optional<PredictedStep::Fit> fit;
  if (next_.is_made()) {
    edge_ = mean_fine_edge(mesh_, step.start);
    fit = next_.fit(step, kMostDeviationInEdges * edge_);
  }
  next_.make(step, sample_, kMostSteps);
  if (!fit) return {};
  same_start_ = fit->start == 0 && fit->deviation <= kLeastSlackInEdges * edge_;
  const bool is_promising =
      same_start_ ? plan_for_same_start(query.question, kMostSteps * fit->end) : plan_steps(query.question, *fit);
  if (!is_promising) return {};
  if (pause_.left > 0) {
    pause_.tick();
    return {};
  }
  queries_served_ = 0;
  predicted_.make(step, mesh_.points(), steps_listed_);
  separation_ = query.separations.fixed;
  if (!follows_prediction(step)) return {};
  auto [start, end] = predicted_.ends(mesh_.vertex_count());
  return Listing{{start, end}, query.separations, slack_, listed_until_, std::move(start), std::move(end)};
}

/// Plans lists for a step from the last query's start in the same direction, `length` times as long. They are for this
/// step alone. For a first contact they end at the time of the last query's first contact. Returns false if that time
/// is unknown.
bool PairsAhead::plan_for_same_start(Question question, double length) {
  constexpr double kBeyond = 1 + 0x1p-10, kLeast = 0x1p-20;
  steps_listed_ = 1;
  slack_ = kLeastSlackInEdges * edge_;
  listed_until_ = 1;
  if (question == Question::all_contacts) return true;
  if (!no_contact_before_) return false;
  if (*no_contact_before_ >= 1 || *no_contact_before_ > kBeyond * length) return true;
  listed_until_ = static_cast<float>(std::min(1.0, kBeyond * *no_contact_before_ / length + kLeast));
  return question == Question::earliest;
}

/// Plans lists for several steps that continue the last one.
bool PairsAhead::plan_steps(Question question, const PredictedStep::Fit& fit) {
  // A search for is_free ends at a contact, at a fraction of the cost of lists. The next step often has one, too.
  if (question == Question::is_free && !(no_contact_before_ && *no_contact_before_ >= 1)) return false;
  steps_listed_ = steps_to_foresee(fit.deviation);
  slack_ = std::max(kLeastSlackInEdges * edge_, steps_listed_ * steps_listed_ * fit.deviation);
  listed_until_ = 1;
  return fit.start > 0 && steps_listed_ >= kFewestSteps;
}

void PairsAhead::end(const ContactCollector& answer) {
  if (answer.query().is_piece) return;
  const Question question = answer.query().question;
  no_contact_before_ = answer.bound().latest();
  if (question == Question::all_contacts) no_contact_before_ = std::min(*no_contact_before_, answer.touched_by());
  const bool ended_early = question == Question::is_free && !answer.contacts().empty();  // sooner or later, by chance
  if (ended_early) no_contact_before_.reset();
}

bool PairsAhead::follows_prediction(const Step& step) {
  const auto fit = predicted_.fit(step, slack_);
  if (!fit) return false;
  when_ = {static_cast<float>(fit->start) - kTimeRounding, static_cast<float>(fit->end) + kTimeRounding};
  return true;
}

/// `deviation`: after one step. Under a constant force it grows with the square of the number of steps.
double PairsAhead::steps_to_foresee(double deviation) const {
  return std::floor(std::min(kMostSteps, std::sqrt(kMostSlackInEdges * edge_ / deviation)));
}

}  // namespace tamis
