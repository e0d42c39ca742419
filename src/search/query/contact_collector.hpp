// Makes answers of decided pairs. It collects all contacts, those that may be the first (of all, or of each pair of
// bodies), or one.
#pragma once
#include <vector>

#include "numbers/held_bytes.hpp"
#include "pair/narrow/decide.hpp"
#include "search/query/bound.hpp"
#include "search/query/first_contact.hpp"
#include "search/query/query.hpp"
#include "tamis/statistics.hpp"

namespace tamis {

/// REQUIRES: a pair that touches.
inline Contact contact_of(PairKind kind, const PairVertices& vertices, const PairResult& r) {
  TAMIS_ASSERT(r.touches);
  return {kind, r.certainty, vertices, r.toi_lower, r.toi_upper, r.u, r.v, r.normal};
}

/// Leaves the first contact of each of the query's answers, in no order.
void keep_firsts(const Query& query, std::vector<Contact>& contacts);

/// One per thread, and one for the answer. The answer does not depend on the order of contacts, nor on which thread
/// adds which.
class ContactCollector {
 public:
  /// Begins a query; the memory stays. Keeps references to query and bound, which all threads share. REQUIRES: a bound
  /// that has begun.
  void begin(const Query& query, Bound& bound);
  /// Takes a decided pair if it touches, if it can change the answer, and if its features are not neighbours. Returns
  /// whether it did. `by_integers`: no cheaper arithmetic could decide the pair. REQUIRES: a kind there is, times in
  /// [0,1] and in order.
  bool add(PairKind kind, const PairVertices& vertices, const PairResult& result, bool by_integers = false);
  /// True if this pair, which is apart before the time `from`, can still change the answer. Cheap: call it before
  /// deciding a pair. A pair that touches at t=0 makes all later pairs in the order of contacts irrelevant. Any contact
  /// ends the question is_free.
  bool wants(PairKind kind, const PairVertices& vertices, double from = 0) const;
  /// True if any pair of this kind can still change the answer.
  bool wants(PairKind kind) const { return query_->each_of || wants(kind, {0, 0, 0, 0}); }
  /// True if it is worth calling `wants` for each pair first. It is not before a known pair touches at t=0, if there is
  /// one answer.
  bool is_choosy() const { return query_->each_of || touches_at_start(0); }
  /// The latest time of interest for this pair.
  double latest(PairKind kind, const PairVertices& vertices) const {
    return bound_->latest(query_->answer_of(kind, vertices));
  }
  /// earliest: until when this pair is of interest. REQUIRES: a pair that is wanted.
  OfInterest of_interest(PairKind kind, const PairVertices& vertices) const {
    const std::size_t answer = query_->answer_of(kind, vertices);
    const double latest = bound_->latest(answer);
    return {latest, first_[answer].needed_until(kind, vertices, latest)};
  }
  /// Takes what `other` has collected, which then is empty.
  void take(ContactCollector& other);
  /// Takes over what `other` knows of the first contact, which spares pairs here.
  void learn(const ContactCollector& other);

  const Query& query() const { return *query_; }
  Bound& bound() const { return *bound_; }
  /// all_contacts: every contact, in no order; is_free: one, if there is any; earliest: none.
  std::vector<Contact>& contacts() { return contacts_; }
  const std::vector<Contact>& contacts() const { return contacts_; }
  /// earliest: the answer.
  EarliestContact first() const { return first_.front().answer(); }
  /// earliest: the first contact of each answer that has one, in no order.
  std::vector<Contact> firsts() const;
  /// all_contacts: some pair has touched by this time; 1 if none is known to.
  double touched_by() const { return touched_by_; }
  /// Pairs that touch at t=0 and do not count.
  void count_ignored() { ++ignored_; }
  std::uint64_t ignored() const { return ignored_; }
  /// Restarts the count: the same pairs will be decided again.
  void count_ignored_anew() { ignored_ = 0; }
  std::uint64_t memory_bytes() const { return held_bytes(contacts_) + first_.capacity() * sizeof(FirstContact); }

 private:
  /// True if a known pair of this answer touches at t=0.
  bool touches_at_start(std::size_t answer) const {
    const EarliestContact& first = first_[answer].earliest();
    return first.contact && first.toi_upper == 0;
  }

  const Query* query_ = nullptr;
  Bound* bound_ = nullptr;
  std::vector<Contact> contacts_;
  std::vector<FirstContact> first_;  ///< earliest: the first of each answer
  double touched_by_ = 1;
  std::uint64_t ignored_ = 0;
};

}  // namespace tamis
