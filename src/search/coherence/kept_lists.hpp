// Lists of pairs that one query makes, with slack, for the queries that follow it. Lists choose which pairs are
// decided; they never change the answer.
#pragma once
#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "search/coherence/pair_lists.hpp"
#include "search/query/query.hpp"

namespace tamis {

/// What to list: all pairs that come within their separations on a step although vertices deviate from it.
struct Listing {
  Step step;
  Separations separations;
  double deviation = 0;                     ///< vertices may be so far, along any axis, from where the step has them
  float until = 1;                          ///< pairs that touch later are not listed
  std::vector<Point> start = {}, end = {};  ///< the positions of `step`, if it was made for this listing
};

/// How long no lists are made after lists that cost more than they saved. Each pause is twice as long as the one
/// before, up to kLongest. Lists that were worth it make the next one short again.
struct ListingPause {
  static constexpr int kLongest = 64;
  int first, next = first, left = 0;

  void begin() { left = std::exchange(next, std::min(2 * next, kLongest)); }
  void tick() { left = std::max(0, left - 1); }
  void lists_were_worth_it() { next = first; }
};

/// Lists, and when they are made anew. Derived classes say which queries the lists serve.
class KeptLists {
 public:
  virtual ~KeptLists() = default;

  /// Called when the lists do not serve this query. Returns the pairs worth listing for this query and the next ones,
  /// if any. Then the caller adds those pairs to lists(), which are empty, and calls end_listing().
  virtual std::optional<Listing> plan(const Query& query) = 0;
  /// Keeps the lists if they are complete, else drops them, as the pairs were too many.
  virtual void end_listing(bool is_complete) {
    are_listed_ = is_complete;
    if (is_complete) return;
    pause_.begin();
    lists_ = {};
  }
  PairLists& lists() { return lists_; }

 protected:
  explicit KeptLists(const ListingPause& pause) : pause_(pause) {}
  void forget() {
    are_listed_ = false;
    lists_.clear();
  }

  PairLists lists_;
  bool are_listed_ = false;
  ListingPause pause_;
};

}  // namespace tamis
