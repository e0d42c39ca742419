#include "search/query/first_contact.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <tuple>

#include "numbers/assert.hpp"

namespace tamis {

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

/// Fractions with few bits, at which whole scenes meet, lie in the middle of their short time. Each operation, rounded,
/// keeps the order of times.
double beginning_of(double time) {
  constexpr std::uint64_t kLastBits = (std::uint64_t{1} << 15) - 1;
  const auto bits = std::bit_cast<std::uint64_t>(time * (1 + 0x1p-39));
  return std::min(time, std::bit_cast<double>(bits & ~kLastBits) * (1 - 0x1p-39));
}

void FirstContact::add(const Contact& contact, bool by_integers) {
  keep_first(first_, contact);
  if (!by_integers) return keep_first(first_by_doubles_, contact);
  const double time = beginning_of(contact.toi_lower);
  if (time > crowd_time_) return;
  if (time < crowd_time_) first_of_crowd_.reset();
  add_to_crowd(time, {contact.kind, contact.vertices});
  if (!first_of_crowd_ || comes_before(contact, *first_of_crowd_)) first_of_crowd_ = contact;
}

void FirstContact::add_to_crowd(double time, const Key& key) {
  TAMIS_ASSERT(time <= crowd_time_);
  if (time < crowd_time_) crowd_.clear();
  crowd_time_ = time;
  if (!is_crowd() && std::find(crowd_.begin(), crowd_.end(), key) == crowd_.end()) crowd_.push_back(key);
}

void FirstContact::add(const FirstContact& other) {
  for (auto [mine, theirs] : {std::pair{&first_, &other.first_}, {&first_by_doubles_, &other.first_by_doubles_}}) {
    if (!theirs->contact) continue;
    keep_first(*mine, *theirs->contact);
    mine->toi_upper = std::min(mine->toi_upper, theirs->toi_upper);
  }
  if (!other.first_of_crowd_ || other.crowd_time_ > crowd_time_) return;
  if (other.crowd_time_ < crowd_time_) first_of_crowd_.reset();
  for (const Key& key : other.crowd_) add_to_crowd(other.crowd_time_, key);
  if (!first_of_crowd_ || comes_before(*other.first_of_crowd_, *first_of_crowd_))
    first_of_crowd_ = other.first_of_crowd_;
}

EarliestContact FirstContact::answer() const {
  if (!is_crowd()) return first_;
  EarliestContact crowd{crowd_time_, first_of_crowd_->toi_upper, first_of_crowd_};
  const EarliestContact& other = first_by_doubles_;
  if (!other.contact) return crowd;
  const bool is_crowd_first = crowd_time_ < other.toi_lower ||
                              (crowd_time_ == other.toi_lower && comes_before(*first_of_crowd_, *other.contact));
  if (is_crowd_first) return crowd;
  return {other.toi_lower, std::min(crowd.toi_upper, other.contact->toi_upper), other.contact};
}

double FirstContact::needed_until(PairKind kind, const PairVertices& vertices, double latest) const {
  const bool is_behind_crowd =
      is_crowd() && std::tie(first_of_crowd_->kind, first_of_crowd_->vertices) < std::tie(kind, vertices);
  if (!is_behind_crowd) return latest;
  const double within = crowd_time_ * (1 + 0x1p-49);  // surely in the crowd's short time, in spite of rounding
  TAMIS_ASSERT(beginning_of(within) >= crowd_time_);
  return std::min(within, latest);
}

}  // namespace tamis
