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

void ContactCollector::begin(const Query& query, Bound& bound) {
  query_ = &query;
  bound_ = &bound;
  contacts_.clear();
  first_ = {};
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
    if (result.toi_lower > bound_->latest()) return false;
    bound_->lower(near_tie(result.toi_upper));
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

bool ContactCollector::wants(PairKind kind, const PairVertices& vertices) const {
  if (query_->question == Question::is_free) return !bound_->is_settled();
  return !touches_at_start() ||
         std::tie(kind, vertices) < std::tie(earliest().contact->kind, earliest().contact->vertices);
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

void ContactCollector::learn(const ContactCollector& other) { first_.add(other.first_); }

EarliestContact ContactCollector::first() {
  reduce_to_first();
  return first_.answer();
}

/// Contacts found in lanes are decided again on the whole step: their last bits depend on how much of the step the
/// search still had to look at, and so on earlier questions.
void ContactCollector::reduce_to_first() {
  for (const Contact& c : contacts_) {
    if (c.toi_lower > bound_->latest() || !wants(c.kind, c.vertices)) continue;
    stop_if_cancelled(*query_);
    const double separation = query_->separations.between(c.kind, c.vertices);
    const PairPoints points = points_of(query_->step, c.vertices);
    const std::uint64_t by_integers = decided_by_.exact;
    const OfInterest times{bound_->latest(), needed_until(c.kind, c.vertices)};
    const PairResult result = decide({c.kind, points, separation}, decided_by_, times);
    const DecidedBy by = decided_by_.exact > by_integers ? DecidedBy::integers : DecidedBy::doubles;
    const PairResult counted = result.touches ? as_counted(c.kind, c.vertices, result) : result;
    if (counted.touches) keep_first(contact_of(c.kind, c.vertices, counted), by);
  }
  contacts_.clear();
}

void ContactCollector::keep_first(const Contact& decided, DecidedBy by) {
  first_.add(decided, by == DecidedBy::integers);
  bound_->lower(near_tie(decided.toi_upper));
}

}  // namespace tamis
