#include "search/query/contact_collector.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "numbers/assert.hpp"
#include "pair/motion/time_clip.hpp"
#include "pair/narrow/sharp_bracket.hpp"
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
  ignored_ = 0;
}

bool ContactCollector::add(PairKind kind, const PairVertices& vertices, const PairResult& result, bool by_integers) {
  if (!result.touches) return false;
  TAMIS_ASSERT(is_kind(kind) && is_part_of_step(TimeInterval<double>{result.toi_lower, result.toi_upper}));
  if (query_->are_neighbours(kind, vertices)) return false;
  if (query_->question == Question::is_free) {
    bound_->settle();
    if (!contacts_.empty()) return false;
  }
  touched_by_ = std::min(touched_by_, result.toi_upper);
  if (query_->question != Question::earliest) {
    contacts_.push_back(contact_of(kind, vertices, result));
    return true;
  }
  const std::size_t answer = query_->answer_of(kind, vertices);
  if (result.toi_lower > bound_->latest(answer)) return false;
  bound_->lower(near_tie(result.toi_upper), answer);
  first_[answer].add(contact_of(kind, vertices, result), by_integers);
  return true;
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
  ignored_ += std::exchange(other.ignored_, 0);
  learn(other);
}

void ContactCollector::learn(const ContactCollector& other) {
  for (std::size_t answer = 0; answer < first_.size(); ++answer) first_[answer].add(other.first_[answer]);
}

std::vector<Contact> ContactCollector::firsts() const {
  std::vector<Contact> contacts;
  for (const FirstContact& of_answer : first_)
    if (const EarliestContact first = of_answer.answer(); first.contact) contacts.push_back(*first.contact);
  return contacts;
}

}  // namespace tamis
