#include "audit/new_pairs.hpp"

#include <algorithm>

namespace tamis::audit {

void NewPairs::mark(FrameFindings& findings) {
  if (!findings.answer.problem.empty()) return;
  const bool is_first = mesh_ == nullptr;
  if (mesh_ != findings.frame->mesh) {
    before_.clear();
    had_step_ = !is_first;
  }
  std::vector<Key> keys;
  keys.reserve(findings.pairs.size());
  findings.is_new.reserve(findings.pairs.size());
  for (Finding& pair : findings.pairs) {
    pair.is_new = !is_first && is_new(pair);
    findings.is_new.push_back(pair.is_new);
    findings.answer.fresh += pair.is_new ? 1 : 0;
    keys.push_back({pair.kind, pair.vertices});
  }
  std::sort(keys.begin(), keys.end());
  before_ = std::move(keys);
  had_step_ = findings.answer.has_step;
  mesh_ = findings.frame->mesh;
}

bool NewPairs::is_new(const Finding& pair) const {
  const bool was_there = !had_step_ && pair.kind != Kind::edge_face && pair.toi_lower == 0;
  return !was_there && !std::binary_search(before_.begin(), before_.end(), Key{pair.kind, pair.vertices});
}

}  // namespace tamis::audit
