// Where a decided pair becomes an answer: all contacts are kept, those that can still be the first, or one.
#pragma once
#include <vector>

#include "numerics/held_bytes.hpp"
#include "query/bound.hpp"
#include "query/pair_rules.hpp"
#include "query/query.hpp"
#include "tamis/statistics.hpp"

namespace tamis {

/// By kind, then vertices; duplicate features leave equal keys, so the time comes last.
bool comes_before(const Contact& a, const Contact& b);

/// REQUIRES: a pair that touches.
inline Contact contact_of(PairKind kind, const PairVertices& vertices, const PairResult& r) {
  TAMIS_ASSERT(r.touches);
  return {kind, r.certainty, vertices, r.toi_lower, r.toi_upper, r.u, r.v, r.normal};
}

/// Keeps in `first` the contact that bounds the step first, and until when one is certain.
void keep_first(EarliestContact& first, const Contact& contact);

/// Singly: by decide() on the whole step.
enum class DecidedBy { lanes, singly };

/// One per thread, and one for the answer. In any order of contacts, shared out in any way, the answer is the same.
class ContactCollector {
 public:
  /// A new query; the memory stays. Query and bound, which all threads share, must outlive the answer. REQUIRES: a
  /// bound that has begun.
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
  /// A pair touches at t=0: from now on it is worth asking `wants` of each pair first.
  bool touches_at_start() const { return first_.contact && first_.toi_upper == 0; }
  /// Takes what `other` has collected, which then is empty.
  void take(ContactCollector& other);
  /// What `other` knows of the first contact spares pairs here.
  void learn(const ContactCollector& other);

  const Query& query() const { return *query_; }
  Bound& bound() const { return *bound_; }
  /// all_contacts: every contact, in no order; is_free: one, if there is any.
  std::vector<Contact>& contacts() { return contacts_; }
  const std::vector<Contact>& contacts() const { return contacts_; }
  /// earliest: the answer, decided on the whole step, so that it does not depend on how far the search still looked.
  EarliestContact first();
  /// A time by which some pair of all_contacts touches; 1: none is known to.
  double touched_by() const { return touched_by_; }
  /// Pairs that it has decided itself.
  const PrecisionCount& decided_by() const { return decided_by_; }
  /// Pairs that touch at t=0 and do not count.
  std::uint64_t ignored() const { return ignored_; }
  /// The same pairs will be looked at again.
  void count_ignored_anew() { ignored_ = 0; }
  std::uint64_t memory_bytes() const { return held_bytes(contacts_); }

 private:
  /// Contacts that `earliest` keeps at most before they are reduced to the first one. One that may touch at t=0, where
  /// nothing comes before it, is not kept at all.
  static constexpr std::size_t kMostContactsKept = 1024;

  /// The contact that counts for the query: the result, or where contacts at the start are ignored, its recontact.
  PairResult as_counted(PairKind kind, const PairVertices& vertices, const PairResult& result);
  void reduce_to_first();
  void keep_first(const Contact& decided);

  const Query* query_ = nullptr;
  Bound* bound_ = nullptr;
  std::vector<Contact> contacts_;  ///< earliest: those not yet decided singly
  EarliestContact first_;          ///< of those that are
  double touched_by_ = 1;
  PrecisionCount decided_by_;
  std::uint64_t ignored_ = 0;
};

}  // namespace tamis
