// Pairs near at the start: a solver that truncates each of its iterations asks about one start again and again. The
// pairs that are so near that their vertices may use up the distance are listed once, and each further question looks
// at those alone. It decides what is looked at, never what the answer is.
#pragma once
#include <array>
#include <vector>

#include "coherence/pair_list.hpp"
#include "numerics/held_bytes.hpp"
#include "query/query.hpp"

namespace tamis {

/// Of questions about step lengths: how far may every pair keep a fraction of its distance at the start?
class PairsOfStart {
 public:
  /// Keeps a reference.
  explicit PairsOfStart(const Mesh& mesh) : mesh_(mesh) {}

  /// A new question. `lists_all`: for every pair that ends the step, as truncations ask after one for a step for all.
  /// True: the lists hold all pairs that may.
  bool begin(const Query& query, double fraction, bool lists_all);
  /// Else, in a truncation: will this start be truncated again, and is a list worth another try? If so, add all pairs
  /// that are within separations() of each other at the start to lists(), then call complete().
  bool plan(const Query& query, double fraction);
  Separations separations() const { return {separation_, reach_}; }
  /// The lists are ready; or the pairs were too many, and there are none. Returns which.
  bool complete(bool hold_all);
  PairLists& lists() { return lists_; }
  std::uint64_t memory_bytes() const { return held_bytes(lists_, start_, ways_, ways_before_, room_, reach_); }

 private:
  bool starts_again(const Step& step) const;
  void start_anew(const Step& step);
  bool covers(const Query& query, double fraction) const;
  double mean_of_ways() const;
  void forget();

  const Mesh& mesh_;
  std::vector<Point> start_;  ///< of the last question
  /// How far each vertex went at most, from this start (in all questions but the first) and from the start before.
  std::vector<double> ways_, ways_before_;
  std::vector<double> room_;   ///< how far each vertex may go and leave pairs that are not listed all of their distance
  std::vector<double> reach_;  ///< that, and the largest radius of its features
  const double* radii_ = nullptr;  ///< the query's when the lists were made
  double separation_ = 0;
  PairLists lists_;
  bool starts_again_ = false;  ///< the last question, as the one before it
  // Lists pay from the second truncation of a start on: is there one from this start, and was there from the last two?
  bool is_truncated_ = false, is_truncated_again_ = false;
  std::array<bool, 2> were_truncated_again_{};
  bool are_listed_ = false;
  ListingPause pause_{1};  ///< in starts
};

}  // namespace tamis
