// What is kept of the contacts an engine finds: all of them, those that can still be the first, or one.
#pragma once
#include <atomic>
#include <memory>
#include <vector>

#include "engines/pair_rules.hpp"
#include "motion/separations.hpp"
#include "tamis/detector.hpp"
#include "tamis/pair.hpp"
#include "tamis/statistics.hpp"

namespace tamis {

/// `candidates`, of the method `tamis` alone: pairs that may touch, listed and not decided.
enum class Question : std::uint8_t { all_contacts, earliest, is_free, candidates };

/// `earliest` looks at every contact that starts up to this factor after the end of another one: no bracket is so
/// wide that the first of two could be lost to rounding.
inline constexpr double kNearTie = 1 + 0x1p-16;

/// By kind, then vertices; duplicate features leave equal keys, so the time comes last.
bool comes_before(const Contact& a, const Contact& b);

/// One per thread, and one for the answer. In any order of contacts, shared out in any way, the answer is the same.
class FoundContacts {
 public:
  /// Keeps a reference.
  explicit FoundContacts(const Options& options) : options_(options) {}

  /// A new question; the memory stays.
  void begin(const Step& step, const Separations& separations, Question question);
  /// The question `candidates`, until there are too many: `stray` is how far vertices may be from where the step has
  /// them.
  void begin_candidates(const Step& step, const Separations& separations, double stray, std::int64_t most);
  /// The question that `answer` has begun with, and what it knows: for a thread that looks for a part of it.
  void begin_part_of(const FoundContacts& answer);
  /// REQUIRES: a kind there is, times in [0,1] and in order.
  void add(const Contact& contact);
  /// Can this pair still change the answer? Cheap, to be asked before a pair is decided: a pair that touches at t=0
  /// makes all that come behind it in the order of contacts irrelevant, and any contact ends the question is_free.
  bool wants(PairKind kind, const PairVertices& vertices) const;
  bool wants(PairKind kind) const { return wants(kind, {0, 0, 0, 0}); }
  /// A pair touches at t=0: from now on it is worth asking `wants` of each pair first.
  bool touches_at_start() const { return first_.contact && first_.toi_upper == 0; }
  /// Of candidates.
  void count_candidates(int count);
  bool are_too_many() const { return shared_->is_settled.load(std::memory_order_relaxed); }
  /// Takes what `other` has found, which then has found nothing.
  void take(FoundContacts& other);
  /// What `other` knows of the first contact bounds what is of interest here.
  void learn(const FoundContacts& other);

  const Step& step() const { return step_; }
  const Separations& separations() const { return separations_; }
  /// By which a pair is decided.
  PairOptions rule_for(PairKind kind, const PairVertices& vertices) const {
    return {.min_separation = separations_.between(kind, vertices)};
  }
  Question question() const { return question_; }
  double stray() const { return stray_; }
  /// Later than this no contact is of interest; 1 if there is no bound.
  double latest() const { return latest_; }
  /// all_contacts: every contact, in no order; is_free: one, if there is any.
  std::vector<Contact>& contacts() { return contacts_; }
  const std::vector<Contact>& contacts() const { return contacts_; }
  /// earliest: the answer, decided on the whole step, so that it does not depend on how far the search still looked.
  EarliestContact first();
  const PrecisionCount& decided_by() const { return decided_by_; }
  std::uint64_t memory_bytes() const { return contacts_.capacity() * sizeof(Contact); }

 private:
  /// Contacts that `earliest` keeps at most before they are reduced to the first one. One that may touch at t=0, where
  /// nothing comes before it, is not kept at all.
  static constexpr std::size_t kMost = 1024;

  void settle();
  void keep_first(const Contact& decided);

  const Options& options_;
  Step step_;
  Separations separations_;
  Question question_ = Question::all_contacts;
  double stray_ = 0;
  struct Shared {
    std::atomic<bool> is_settled = false;           ///< is_free: somebody has found a contact; candidates: too many
    std::atomic<std::int64_t> candidates_left = 0;  ///< to be found before they are too many
  };
  std::shared_ptr<Shared> own_ = std::make_shared<Shared>();
  std::shared_ptr<Shared> shared_ = own_;  ///< by all who look for a part of the answer
  std::vector<Contact> contacts_;          ///< earliest: those not yet decided on the whole step
  double latest_ = 1;
  EarliestContact first_;  ///< of those that are
  PrecisionCount decided_by_;
};

}  // namespace tamis
