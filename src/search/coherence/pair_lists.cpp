#include "search/coherence/pair_lists.hpp"

#include <algorithm>
#include <iterator>

#include "numbers/assert.hpp"

namespace tamis {

bool PairList::empty() const {
  return std::ranges::all_of(parts_, [](const auto& part) { return part.empty(); });
}

void PairList::add(const PairBuffer& pairs) {
  TAMIS_ASSERT(0 <= pairs.count && pairs.count <= PairBuffer::kCapacity);
  const auto& corner = pairs.corner;
  for (int i = 0; i < pairs.count; ++i) {
    if (parts_.empty() || parts_.back().size() == kPairsPerPart) {
      parts_.emplace_back();
      if (parts_.size() > 1) parts_.back().reserve(kPairsPerPart);  // lists of few pairs need little memory
    }
    parts_.back().push_back(
        {{corner[0][i], corner[1][i], corner[2][i], corner[3][i]}, {pairs.t_in[i], pairs.t_out[i]}});
  }
}

void PairList::take(PairList& other) {
  if (empty())
    parts_.swap(other.parts_);
  else
    std::ranges::move(other.parts_, std::back_inserter(parts_));
  other.clear();
}

void PairList::clear() {
  parts_.resize(std::min<std::size_t>(parts_.size(), 1));
  for (auto& part : parts_) part.clear();
}

void append(std::span<const Candidate> listed, const TimeInterval<float>& when, float t_limit, PairBuffer& pairs) {
  TAMIS_ASSERT(listed.size() <= static_cast<std::size_t>(PairBuffer::kCapacity - pairs.count));
  TAMIS_ASSERT(when.t_in <= when.t_out && 0 <= t_limit && t_limit <= 1);
  int count = pairs.count;
  for (const Candidate& pair : listed) {  // without branches on times: what is not kept is overwritten
    for (std::size_t c = 0; c < pair.corners.size(); ++c) pairs.corner[c][count] = pair.corners[c];
    pairs.t_in[count] = 0;
    pairs.t_out[count] = t_limit;
    count += pair.time.t_in <= when.t_out && pair.time.t_out >= when.t_in;
  }
  pairs.count = count;
}

bool PairLists::any() const {
  return std::ranges::any_of(lists_, [](const PairList& list) { return !list.empty(); });
}

void PairLists::take(PairLists& other) {
  for (std::size_t kind = 0; kind < kPairKinds; ++kind) lists_[kind].take(other.lists_[kind]);
}

void PairLists::clear() {
  for (PairList& list : lists_) list.clear();
}

}  // namespace tamis
