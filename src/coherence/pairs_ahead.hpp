// Pairs listed ahead: where a mesh goes on as it did, or is asked about the same step again, as in a line search, the
// pairs that may come near on its predicted step are found once, and each of these queries asks about those alone. It
// decides what is looked at, never what the answer is.
#pragma once
#include <vector>

#include "coherence/forecast.hpp"
#include "coherence/pair_list.hpp"
#include "numerics/held_bytes.hpp"
#include "query/contact_collector.hpp"

namespace tamis {

/// About what a search has cost: of its trees, refitting and visiting, and of the pairs whose boxes met.
struct SearchWork {
  std::uint64_t trees = 0, pairs = 0;
};

/// Bounded memory: as many pairs as CandidateSearch lists, 24 bytes each, with room to grow to twice that; and
/// positions.
class PairsAhead {
 public:
  /// Keeps a reference.
  explicit PairsAhead(const Mesh& mesh);

  /// A new query. True: the lists hold the pairs that may touch, unless leaves_undecided() says otherwise then.
  bool begin(const Query& query);
  /// The listed pairs have been decided, and a contact may be among others: the trees must be searched.
  bool leaves_undecided(const ContactCollector& answer) const;
  /// Else: did the last query foresee this one, so that lists promise to help the next ones? If so, search
  /// predicted_ends() for pairs that may touch before until() while every vertex is within slack() of it, add them to
  /// lists(), then call complete().
  bool plan(const Query& query);
  Forecast::Ends predicted_ends() const { return predicted_.ends(mesh_.vertex_count()); }
  double slack() const { return slack_; }
  /// A part of the predicted step.
  float until() const { return until_; }
  /// What the pairs of the lists may cost at most (SearchWork), beside trees that cost what those of a search do.
  std::uint64_t most_work(Question question) const;
  /// The lists are ready; or the pairs were too many, and there are none. Returns which.
  bool complete(bool hold_all);
  /// This query, as part of the predicted step.
  const TimeInterval<float>& when() const { return when_; }
  PairLists& lists() { return lists_; }
  void end(const ContactCollector& answer, const SearchWork& work);
  std::uint64_t memory_bytes() const { return held_bytes(lists_, next_, predicted_, sample_); }

 private:
  bool plan_again(Question question, double length);
  bool plan_steps(Question question, const Forecast::Fit& fit);
  /// Do the lists hold all that may touch until this part of the predicted step?
  bool covers(float time) const { return until_ == 1 || time <= until_; }
  /// Sets when_.
  bool follows_prediction(const Step& step);
  void forget();
  void learn();
  double steps_to_foresee(double deviation) const;

  const Mesh& mesh_;
  std::vector<Index> sample_;  ///< some vertices in use
  Forecast next_;              ///< by the last query, of the sample
  Forecast predicted_;         ///< that the lists are for, of all vertices in use
  double slack_ = 0;           ///< how far vertices may deviate from it
  double edge_ = 0;            ///< mean length, when last planned
  double separation_ = 0;      ///< asked for when the lists were made
  TimeInterval<float> when_{};
  PairLists lists_;
  bool are_listed_ = false;
  bool starts_again_ = false;                    ///< the query that planned them started as the one before it did
  float until_ = 1;                              ///< when the lists end
  std::optional<double> no_contact_before_ = 1;  ///< of the last query's step; 1: none at all; nothing: not known
  int free_in_row_ = 0;                          ///< the last queries: no contact at all
  double steps_;                                 ///< to look ahead
  double steps_listed_ = 0;
  SearchWork last_search_;  ///< the last one of trees that went to its end
  int queries_served_ = 0;  ///< by these lists
  ListingPause pause_;      ///< in queries
};

}  // namespace tamis
