#include "engines/found_contacts.hpp"

#include <algorithm>
#include <tuple>

#include "engines/cancellation.hpp"
#include "motion/time_clip.hpp"
#include "narrow/decide.hpp"
#include "numerics/assert.hpp"

namespace tamis {
namespace {

/// The contact as decided on the whole step: the last bits of what an engine found depend on how far it still had to
/// look, and so on earlier questions.
Contact decided_anew(const Contact& c, const Step& step, const PairOptions& rule, PrecisionCount& decided_by) {
  const auto r = decide(c.kind, points_of(step, c.vertices), rule, decided_by);
  TAMIS_ASSERT(r.touches);
  return {c.kind, r.certainty, c.vertices, r.toi_lower, r.toi_upper, r.u, r.v, r.normal};
}

}  // namespace

bool comes_before(const Contact& a, const Contact& b) {
  return std::tie(a.kind, a.vertices, a.toi_lower, a.toi_upper) <
         std::tie(b.kind, b.vertices, b.toi_lower, b.toi_upper);
}

void FoundContacts::begin(const Step& step, const Separations& separations, Question question) {
  step_ = step;
  separations_ = separations;
  question_ = question;
  stray_ = 0;
  shared_ = own_;
  shared_->is_settled.store(false, std::memory_order_relaxed);
  contacts_.clear();
  latest_ = 1;
  first_ = {};
  decided_by_ = {};
}

void FoundContacts::begin_candidates(const Step& step, const Separations& separations, double stray,
                                     std::int64_t most) {
  begin(step, separations, Question::candidates);
  stray_ = stray;
  shared_->candidates_left.store(most, std::memory_order_relaxed);
}

void FoundContacts::begin_part_of(const FoundContacts& answer) {
  begin(answer.step_, answer.separations_, answer.question_);
  stray_ = answer.stray_;
  shared_ = answer.shared_;
  learn(answer);
}

void FoundContacts::count_candidates(int count) {
  const std::int64_t left = shared_->candidates_left.fetch_sub(count, std::memory_order_relaxed) - count;
  if (left < 0) shared_->is_settled.store(true, std::memory_order_relaxed);
}

void FoundContacts::add(const Contact& contact) {
  TAMIS_ASSERT(is_kind(contact.kind) && is_part_of_step(TimeInterval<double>{contact.toi_lower, contact.toi_upper}));
  if (question_ == Question::is_free) {
    if (contacts_.empty()) contacts_.push_back(contact);
    shared_->is_settled.store(true, std::memory_order_relaxed);
    return;
  }
  if (question_ == Question::earliest) {
    if (contact.toi_lower > latest_) return;
    latest_ = std::min(latest_, contact.toi_upper * kNearTie);
  }
  contacts_.push_back(contact);
  if (question_ == Question::earliest && (contacts_.size() >= kMost || contact.toi_lower == 0)) settle();
}

bool FoundContacts::wants(PairKind kind, const PairVertices& vertices) const {
  if (question_ == Question::is_free || question_ == Question::candidates)
    return !shared_->is_settled.load(std::memory_order_relaxed);
  return !touches_at_start() || std::tie(kind, vertices) < std::tie(first_.contact->kind, first_.contact->vertices);
}

void FoundContacts::take(FoundContacts& other) {
  if (contacts_.empty())
    contacts_.swap(other.contacts_);
  else
    contacts_.insert(contacts_.end(), other.contacts_.begin(), other.contacts_.end());
  other.contacts_.clear();
  decided_by_ += other.decided_by_;
  other.decided_by_ = {};
  learn(other);
}

void FoundContacts::learn(const FoundContacts& other) {
  latest_ = std::min(latest_, other.latest_);
  if (!other.first_.contact) return;
  first_.toi_upper = std::min(first_.toi_upper, other.first_.toi_upper);
  keep_first(*other.first_.contact);
}

EarliestContact FoundContacts::first() {
  settle();
  return first_;
}

void FoundContacts::settle() {
  for (const Contact& c : contacts_) {
    if (c.toi_lower > latest_ || !wants(c.kind, c.vertices)) continue;
    stop_if_cancelled(options_);
    keep_first(decided_anew(c, step_, rule_for(c.kind, c.vertices), decided_by_));
  }
  contacts_.clear();
}

void FoundContacts::keep_first(const Contact& decided) {
  first_.toi_upper = std::min(first_.toi_upper, decided.toi_upper);
  latest_ = std::min(latest_, decided.toi_upper * kNearTie);
  const bool is_first = !first_.contact || decided.toi_lower < first_.toi_lower ||
                        (decided.toi_lower == first_.toi_lower && comes_before(decided, *first_.contact));
  if (!is_first) return;
  first_.toi_lower = decided.toi_lower;
  first_.contact = decided;
}

}  // namespace tamis
