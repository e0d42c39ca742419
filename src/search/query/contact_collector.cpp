#include "search/query/contact_collector.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "numbers/assert.hpp"
#include "pair/motion/time_clip.hpp"
#include "pair/narrow/decide.hpp"
#include "pair/narrow/sharp_bracket.hpp"
#include "search/query/cancellation.hpp"
#include "search/topology/countable.hpp"

namespace tamis {

void keep_firsts(const Query& query, std::vector<Contact>& contacts) {
  std::vector<EarliestContact> firsts(query.answers());
  for (const Contact& contact : contacts) keep_first(firsts[query.answer_of(contact.kind, contact.vertices)], contact);
  contacts.clear();
  for (const EarliestContact& first : firsts)
    if (first.contact) contacts.push_back(*first.contact);
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
    bound_->lower(near_tie(result.toi_upper), answer);
  }
  touched_by_ = std::min(touched_by_, result.toi_upper);
  if (question == Question::earliest && by != DecidedBy::lanes) {
    keep_first(contact_of(kind, vertices, result), by);
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
  const Contact& first = *first_[answer].earliest().contact;
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
  for (std::size_t answer = 0; answer < first_.size(); ++answer) first_[answer].add(other.first_[answer]);
}

EarliestContact ContactCollector::first() {
  reduce_to_first();
  return first_.front().answer();
}

std::vector<Contact> ContactCollector::firsts() {
  reduce_to_first();
  std::vector<Contact> contacts;
  for (const FirstContact& of_answer : first_)
    if (const EarliestContact first = of_answer.answer(); first.contact) contacts.push_back(*first.contact);
  return contacts;
}

/// Contacts found in lanes are decided again on the whole step: their last bits depend on how much of the step the
/// search still had to look at, and so on earlier questions.
void ContactCollector::reduce_to_first() {
  for (const Contact& c : contacts_) {
    if (!wants(c.kind, c.vertices, c.toi_lower)) continue;
    stop_if_cancelled(*query_);
    const double separation = query_->separations.between(c.kind, c.vertices);
    const PairPoints points = points_of(query_->step, c.vertices);
    const std::uint64_t by_integers = decided_by_.exact;
    const PairResult result = decide({c.kind, points, separation}, decided_by_, of_interest(c.kind, c.vertices));
    const DecidedBy by = decided_by_.exact > by_integers ? DecidedBy::integers : DecidedBy::doubles;
    const PairResult counted = result.touches ? as_counted(c.kind, c.vertices, result) : result;
    if (counted.touches) keep_first(contact_of(c.kind, c.vertices, counted), by);
  }
  contacts_.clear();
}

void ContactCollector::keep_first(const Contact& decided, DecidedBy by) {
  const std::size_t answer = query_->answer_of(decided.kind, decided.vertices);
  first_[answer].add(decided, by == DecidedBy::integers);
  bound_->lower(near_tie(decided.toi_upper), answer);
}

}  // namespace tamis
