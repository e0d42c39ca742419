#include "coherence/pair_list.hpp"

#include <algorithm>
#include <utility>

#include "numerics/assert.hpp"

namespace tamis {
namespace {

template <class T>
void append_to(std::vector<T>& to, const std::vector<T>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

}  // namespace

void PairList::clear() {
  for (auto& corner : corner_) corner.clear();
  t_in_.clear();
  t_out_.clear();
}

void PairList::append(const PairBuffer& pairs, std::size_t corners) {
  TAMIS_ASSERT(0 <= pairs.count && pairs.count <= PairBuffer::kCapacity && corners <= kCorners);
  TAMIS_ASSERT(size() == 0 ||
               (corner_[corners - 1].size() == size() && (corners == kCorners || corner_[corners].empty())));
  for (std::size_t c = 0; c < corners; ++c)
    corner_[c].insert(corner_[c].end(), pairs.corner[c], pairs.corner[c] + pairs.count);
  t_in_.insert(t_in_.end(), pairs.t_in, pairs.t_in + pairs.count);
  t_out_.insert(t_out_.end(), pairs.t_out, pairs.t_out + pairs.count);
}

void PairList::take(PairList& other) {
  if (size() == 0) return std::swap(*this, other);
  for (std::size_t c = 0; c < kCorners; ++c) {
    TAMIS_ASSERT(other.size() == 0 || corner_[c].empty() == other.corner_[c].empty());
    append_to(corner_[c], other.corner_[c]);
  }
  append_to(t_in_, other.t_in_);
  append_to(t_out_, other.t_out_);
  other.clear();
}

void PairList::copy(std::size_t first, std::size_t last, const TimeInterval<float>& when, float t_limit,
                    PairBuffer& pairs) const {
  TAMIS_ASSERT(first <= last && last <= t_in_.size() &&
               last - first <= static_cast<std::size_t>(PairBuffer::kCapacity - pairs.count));
  TAMIS_ASSERT(when.t_in <= when.t_out && 0 <= t_limit && t_limit <= 1);
  std::size_t kept[PairBuffer::kCapacity];
  std::size_t count = 0;
  for (std::size_t i = first; i < last; ++i) {
    kept[count] = i;
    count += t_in_[i] <= when.t_out && t_out_[i] >= when.t_in;
  }
  const auto to = static_cast<std::size_t>(pairs.count);
  for (std::size_t c = 0; c < kCorners; ++c)
    if (!corner_[c].empty())
      for (std::size_t i = 0; i < count; ++i) pairs.corner[c][to + i] = corner_[c][kept[i]];
  std::fill_n(pairs.t_in + to, count, 0.0f);
  std::fill_n(pairs.t_out + to, count, t_limit);
  pairs.count += static_cast<int>(count);
}

bool PairLists::any() const {
  return std::ranges::any_of(lists_, [](const PairList& list) { return list.size() > 0; });
}

void PairLists::take(PairLists& other) {
  for (std::size_t kind = 0; kind < kPairKinds; ++kind) lists_[kind].take(other.lists_[kind]);
}

void PairLists::clear() {
  for (PairList& list : lists_) list.clear();
}

}  // namespace tamis
