// Makes answers of decided pairs: collects all contacts, those that may be the first, or one.
#pragma once
#include <vector>

#include "numerics/held_bytes.hpp"
#include "query/bound.hpp"
#include "query/first_contact.hpp"
#include "query/query.hpp"
#include "tamis/statistics.hpp"

namespace tamis {

/// REQUIRES: a pair that touches.
inline Contact contact_of(PairKind kind, const PairVertices& vertices, const PairResult& r) {
  TAMIS_ASSERT(r.touches);
  return {kind, r.certainty, vertices, r.toi_lower, r.toi_upper, r.u, r.v, r.normal};
}

/// How a pair was decided: in lanes, or by decide() on the whole step.
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
  /// Can this pair still change the answer? Cheap, to be asked before a pair is decided: a pair that touches at t=0
  /// makes all that come behind it in the order of contacts irrelevant, and any contact ends the question is_free.
  bool wants(PairKind kind, const PairVertices& vertices) const;
  bool wants(PairKind kind) const { return wants(kind, {0, 0, 0, 0}); }
  /// Does a known pair touch at t=0? From then on it is worth asking `wants` of each pair first.
  bool touches_at_start() const { return earliest().contact && earliest().toi_upper == 0; }
  /// earliest: as FirstContact::needed_until.
  double needed_until(PairKind kind, const PairVertices& vertices) const {
    return first_.needed_until(kind, vertices, bound_->latest());
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
  /// all_contacts: a time by which some pair has touched; 1 if none is known to.
  double touched_by() const { return touched_by_; }
  /// Counts the pairs that the collector has decided itself.
  const PrecisionCount& decided_by() const { return decided_by_; }
  /// Pairs that touch at t=0 and do not count.
  std::uint64_t ignored() const { return ignored_; }
  /// Restarts the count: the same pairs will be decided again.
  void count_ignored_anew() { ignored_ = 0; }
  std::uint64_t memory_bytes() const { return held_bytes(contacts_); }

 private:
  /// `earliest` collects at most so many contacts before it reduces them to the first one. A contact at t=0 is reduced
  /// at once.
  static constexpr std::size_t kMostContactsKept = 1024;

  /// The contact that counts for the query: the result, or where contacts at the start are ignored, its recontact.
  PairResult as_counted(PairKind kind, const PairVertices& vertices, const PairResult& result);
  void reduce_to_first();
  void keep_first(const Contact& decided, DecidedBy by);
  const EarliestContact& earliest() const { return first_.earliest(); }

  const Query* query_ = nullptr;
  Bound* bound_ = nullptr;
  std::vector<Contact> contacts_;  ///< earliest: those not yet decided singly
  FirstContact first_;             ///< the first of those decided singly
  double touched_by_ = 1;
  PrecisionCount decided_by_;
  std::uint64_t ignored_ = 0;
};

}  // namespace tamis
