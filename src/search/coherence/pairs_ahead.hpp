// Pairs listed ahead. While a mesh moves as before, or the same step is queried again, as in a line search, the pairs
// that may touch on the predicted step are listed once. The queries that follow the prediction decide only those.
#pragma once
#include <vector>

#include "numbers/held_bytes.hpp"
#include "search/coherence/kept_lists.hpp"
#include "search/coherence/predicted_step.hpp"
#include "search/query/contact_collector.hpp"

namespace tamis {

/// Memory is bounded: by the most pairs that CandidateSearch lists, 24 bytes each, with room to grow to twice that.
/// Positions come on top.
class PairsAhead final : public KeptLists {
 public:
  /// Keeps a reference.
  explicit PairsAhead(const Mesh& mesh);

  /// Begins a query. Returns true if it follows the prediction. Then its listed pairs are to be decided first.
  bool begin(const Query& query);
  /// Call it after the listed pairs have been decided. True if another pair may still touch, so the trees must be
  /// searched.
  bool leaves_undecided(const ContactCollector& answer) const;
  /// Lists are worth making if the query continues the last one. They then hold the pairs of the predicted step.
  std::optional<Listing> plan(const Query& query) override;
  /// The times of the predicted step that this query covers.
  const TimeInterval<float>& when() const { return when_; }
  /// Learns from a query that has been answered.
  void end(const ContactCollector& answer);
  std::uint64_t memory_bytes() const { return held_bytes(lists_, next_, predicted_, sample_); }

 private:
  bool plan_for_same_start(Question question, double length);
  bool plan_steps(Question question, const PredictedStep::Fit& fit);
  /// True if the lists hold every pair that may touch until this time of the predicted step.
  bool covers(float time) const { return listed_until_ == 1 || time <= listed_until_; }
  /// True if the step follows the predicted one within the slack. Sets when_.
  bool follows_prediction(const Step& step);
  double steps_to_foresee(double deviation) const;

  const Mesh& mesh_;
  std::vector<Index> sample_;  ///< some vertices in use
  PredictedStep next_;         ///< the step predicted from the last query, for the sample
  PredictedStep predicted_;    ///< the predicted step that the lists are for, for all vertices in use
  double slack_ = 0;           ///< how far vertices may deviate from predicted_
  double edge_ = 0;            ///< the mean edge of the finest part, when lists were last planned
  double separation_ = 0;      ///< fixed separation of the query for which the lists were made
  TimeInterval<float> when_{};
  bool same_start_ = false;  ///< the lists are for one step, with the start of the query before
  float listed_until_ = 1;   ///< pairs are listed until this time of the predicted step
  std::optional<double> no_contact_before_ =
      1;  ///< the last query's step is free until then, 1: to its end; nothing: unknown
  double steps_listed_ = 0;
  int queries_served_ = 0;  ///< how many queries these lists have served
};

}  // namespace tamis
