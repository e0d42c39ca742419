#include "query/contact_collector.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "motion/time_clip.hpp"
#include "narrow/decide.hpp"
#include "narrow/sharp_bracket.hpp"
#include "numerics/assert.hpp"
#include "query/cancellation.hpp"
#include "topology/countable.hpp"

namespace tamis {

namespace {

std::vector<Contact> contacts_of(const std::vector<EarliestContact>& firsts) {
  std::vector<Contact> contacts;
  for (const EarliestContact& first : firsts)
    if (first.contact) contacts.push_back(*first.contact);
  return contacts;
}

}  // namespace

bool comes_before(const Contact& a, const Contact& b) {
  return std::tie(a.kind, a.vertices, a.toi_lower, a.toi_upper) <
         std::tie(b.kind, b.vertices, b.toi_lower, b.toi_upper);
}

void keep_first(EarliestContact& first, const Contact& contact) {
  if (contact.certainty == Certainty::certified) first.toi_upper = std::min(first.toi_upper, contact.toi_upper);
  const bool is_first = !first.contact || contact.toi_lower < first.toi_lower ||
                        (contact.toi_lower == first.toi_lower && comes_before(contact, *first.contact));
  if (!is_first) return;
  first.toi_lower = contact.toi_lower;
  first.contact = contact;
}

void keep_firsts(const Query& query, std::vector<Contact>& contacts) {
  std::vector<EarliestContact> firsts(query.answers());
  for (const Contact& contact : contacts) keep_first(firsts[query.answer_of(contact.kind, contact.vertices)], contact);
  contacts = contacts_of(firsts);
}

void ContactCollector::begin(const Query& query, Bound& bound) {
  query_ = &query;
  bound_ = &bound;
  contacts_.clear();
  first_.assign(query.answers(), {});
  touched_by_ = 1;
  decided_by_ = {};
  ignored_ = 0;
}

bool ContactCollector::add(PairKind kind, const PairVertices& vertices, const PairResult& found, DecidedBy by) {
  if (!found.touches) return false;
  TAMIS_ASSERT(is_kind(kind) && is_part_of_step(TimeInterval<double>{found.toi_lower, found.toi_upper}));
  if (query_->are_neighbours(kind, vertices)) return false;
  const PairResult result = as_counted(kind, vertices, found);
  if (!result.touches) {
    ++ignored_;
    return false;
  }
  const Question question = query_->question;
  if (question == Question::is_free) {
    bound_->settle();
    if (!contacts_.empty()) return false;
  }
  if (question == Question::earliest) {
    const std::size_t answer = query_->answer_of(kind, vertices);
    if (result.toi_lower > bound_->latest(answer)) return false;
    bound_->lower(result.toi_upper * kNearTie, answer);
  }
  touched_by_ = std::min(touched_by_, result.toi_upper);
  if (question == Question::earliest && by == DecidedBy::singly) {
    keep_first(contact_of(kind, vertices, result));
    return true;
  }
  contacts_.push_back(contact_of(kind, vertices, result));
  if (question == Question::earliest && (contacts_.size() >= kMostContactsKept || result.toi_lower == 0))
    reduce_to_first();
  return true;
}

PairResult ContactCollector::as_counted(PairKind kind, const PairVertices& vertices, const PairResult& result) {
  if (!query_->ignores_start || result.toi_upper > 0) return result;
  return decide_recontact({kind, points_of(query_->step, vertices), query_->separations.between(kind, vertices)},
                          decided_by_);
}

bool ContactCollector::wants(PairKind kind, const PairVertices& vertices, double from) const {
  if (query_->question == Question::is_free) return !bound_->is_settled();
  const std::size_t answer = query_->answer_of(kind, vertices);
  if (from > bound_->latest(answer)) return false;
  if (!touches_at_start(answer)) return true;
  const Contact& first = *first_[answer].contact;
  return std::tie(kind, vertices) < std::tie(first.kind, first.vertices);
}

void ContactCollector::take(ContactCollector& other) {
  require_countable_pairs(contacts_.size() + other.contacts_.size());
  if (contacts_.empty())
    contacts_.swap(other.contacts_);
  else
    contacts_.insert(contacts_.end(), other.contacts_.begin(), other.contacts_.end());
  other.contacts_.clear();
  touched_by_ = std::min(touched_by_, other.touched_by_);
  decided_by_ += other.decided_by_;
  other.decided_by_ = {};
  ignored_ += std::exchange(other.ignored_, 0);
  learn(other);
}

void ContactCollector::learn(const ContactCollector& other) {
  for (std::size_t answer = 0; answer < first_.size(); ++answer) {
    const EarliestContact& known = other.first_[answer];
    if (!known.contact) continue;
    first_[answer].toi_upper = std::min(first_[answer].toi_upper, known.toi_upper);
    keep_first(*known.contact);
  }
}

EarliestContact ContactCollector::first() {
  reduce_to_first();
  return first_.front();
}

std::vector<Contact> ContactCollector::firsts() {
  reduce_to_first();
  return contacts_of(first_);
}

/// Contacts found in lanes are decided again on the whole step: their last bits depend on how much of the step the
/// search still had to look at, and so on earlier questions.
void ContactCollector::reduce_to_first() {
  for (const Contact& c : contacts_) {
    if (!wants(c.kind, c.vertices, c.toi_lower)) continue;
    stop_if_cancelled(*query_);
    const double separation = query_->separations.between(c.kind, c.vertices);
    const PairResult result = decide({c.kind, points_of(query_->step, c.vertices), separation}, decided_by_);
    keep_first(contact_of(c.kind, c.vertices, as_counted(c.kind, c.vertices, result)));
  }
  contacts_.clear();
}

void ContactCollector::keep_first(const Contact& decided) {
  const std::size_t answer = query_->answer_of(decided.kind, decided.vertices);
  tamis::keep_first(first_[answer], decided);
  bound_->lower(decided.toi_upper * kNearTie, answer);
}

}  // namespace tamis
