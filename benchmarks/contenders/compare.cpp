#include "benchmarks/contenders/contender.hpp"

namespace tamis::bench {

Answer compare(const Task& task, const std::vector<Pair>& touching, bool knows_vf, bool knows_ee) {
  Answer answer;
  std::uint64_t right = 0, wanted = 0;
  for (const Pair& pair : touching) {
    ++(pair.kind == PairKind::vertex_face ? answer.vf : answer.ee);
    ++(task.contacts.contains(pair) ? right : answer.extra);
  }
  for (const Pair& pair : task.contacts) wanted += (pair.kind == PairKind::vertex_face ? knows_vf : knows_ee) ? 1 : 0;
  answer.missed = wanted - right;
  return answer;
}

}  // namespace tamis::bench
