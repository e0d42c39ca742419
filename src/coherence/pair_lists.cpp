#include "coherence/pair_lists.hpp"

#include <algorithm>

#include "numerics/assert.hpp"

namespace tamis {

void append(const PairBuffer& pairs, std::vector<Candidate>& list) {
  TAMIS_ASSERT(0 <= pairs.count && pairs.count <= PairBuffer::kCapacity);
  const auto& corner = pairs.corner;
  for (int i = 0; i < pairs.count; ++i)
    list.push_back({{corner[0][i], corner[1][i], corner[2][i], corner[3][i]}, {pairs.t_in[i], pairs.t_out[i]}});
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
  return std::ranges::any_of(lists_, [](const auto& list) { return !list.empty(); });
}

void PairLists::take(PairLists& other) {
  for (std::size_t kind = 0; kind < kPairKinds; ++kind) {
    auto &mine = lists_[kind], &theirs = other.lists_[kind];
    if (mine.empty())
      mine.swap(theirs);
    else
      mine.insert(mine.end(), theirs.begin(), theirs.end());
    theirs.clear();
  }
}

void PairLists::clear() {
  for (auto& list : lists_) list.clear();
}

}  // namespace tamis
