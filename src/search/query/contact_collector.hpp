// Makes answers of decided pairs: collects all contacts, those that may be the first (of all, or of each pair of
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

/// How a pair was decided: in lanes on a part of the step, or by decide() on the whole step, or with its bits.
enum class DecidedBy { lanes, doubles, integers };

/// One per thread, and one for the answer. The answer does not depend on the order of contacts, nor on which thread
/// adds which.
class ContactCollector {
 public:
  /// Begins a query; the memory stays. Keeps references to query and bound, which all threads share. REQUIRES: a bound
  /// that has begun.
  void begin(const Query& query, Bound& bound);
  /// Takes a decided pair if it touches and counts: its features are no neighbours, and where the query ignores the
  /// start, a pair that touches at t=0 counts by its recontact. Returns true if it is among the contacts now.
  /// `earliest` decides again what lanes decided, and keeps what was decided singly. REQUIRES: a kind there is, times
  /// in [0,1] and in order.
  bool add(PairKind kind, const PairVertices& vertices, const PairResult& result, DecidedBy by = DecidedBy::lanes);
  /// Can this pair, which is apart before the time `from`, still change the answer? Cheap, to be asked before a pair is
  /// decided: a pair that touches at t=0 makes all that come behind it in the order of contacts irrelevant, and any
  /// contact ends the question is_free.
  bool wants(PairKind kind, const PairVertices& vertices, double from = 0) const;
  /// Can any pair of this kind?
  bool wants(PairKind kind) const { return query_->each_of || wants(kind, {0, 0, 0, 0}); }
  /// Is it worth asking `wants` of each pair first? Not before a known pair touches at t=0, if there is one answer.
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
  /// all_contacts: every contact, in no order; is_free: one, if there is any.
  std::vector<Contact>& contacts() { return contacts_; }
  const std::vector<Contact>& contacts() const { return contacts_; }
  /// earliest: the answer, decided on the whole step, so that it does not depend on how far the search still looked.
  EarliestContact first();
  /// earliest: the first contact of each answer that has one, in no order.
  std::vector<Contact> firsts();
  /// all_contacts: a time by which some pair has touched; 1 if none is known to.
  double touched_by() const { return touched_by_; }
  /// Counts the pairs that the collector has decided itself.
  const PrecisionCount& decided_by() const { return decided_by_; }
  /// Pairs that touch at t=0 and do not count.
  std::uint64_t ignored() const { return ignored_; }
  /// Restarts the count: the same pairs will be decided again.
  void count_ignored_anew() { ignored_ = 0; }
  std::uint64_t memory_bytes() const { return held_bytes(contacts_) + first_.capacity() * sizeof(FirstContact); }

 private:
  /// `earliest` collects at most so many contacts before it reduces them to the first one. A contact at t=0 is reduced
  /// at once.
  static constexpr std::size_t kMostContactsKept = 1024;

  /// The contact that counts for the query: the result, or where contacts at the start are ignored, its recontact.
  PairResult as_counted(PairKind kind, const PairVertices& vertices, const PairResult& result);
  void reduce_to_first();
  void keep_first(const Contact& decided, DecidedBy by);
  /// Does a known pair of this answer touch at t=0?
  bool touches_at_start(std::size_t answer) const {
    const EarliestContact& first = first_[answer].earliest();
    return first.contact && first.toi_upper == 0;
  }

  const Query* query_ = nullptr;
  Bound* bound_ = nullptr;
  std::vector<Contact> contacts_;    ///< earliest: those not yet decided singly
  std::vector<FirstContact> first_;  ///< for each answer the first of those decided singly
  double touched_by_ = 1;
  PrecisionCount decided_by_;
  std::uint64_t ignored_ = 0;
};

}  // namespace tamis
