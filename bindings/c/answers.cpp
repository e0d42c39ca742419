#include "c/answers.hpp"

#include <algorithm>
#include <array>

#include "c/kind.hpp"

namespace tamis::c {

tamis_statistics statistics_of(const Statistics& s, std::vector<std::string>& names) {
  tamis_statistics answer{};
  answer.isa = name_of(s.isa).data();  // a literal
  answer.threads = s.threads;
  answer.rebuilt = s.rebuilt ? 1 : 0;
  answer.seconds_total = s.seconds.total;
  answer.seconds_bounds = s.seconds.bounds;
  answer.seconds_build = s.seconds.build;
  answer.seconds_traverse = s.seconds.traverse;
  answer.seconds_filter = s.seconds.filter;
  answer.seconds_solve = s.seconds.solve;
  answer.decided_by_lanes = s.decided_by.lanes;
  answer.decided_by_scalar = s.decided_by.scalar;
  answer.decided_by_exact = s.decided_by.exact;
  answer.unresolved = s.decided_by.unresolved;
  answer.nodes_visited = s.nodes_visited;
  answer.memory_bytes = s.memory_bytes;
  answer.ignored = s.ignored;
  const std::size_t count = std::min<std::size_t>(s.stages.size(), TAMIS_MOST_STAGES);
  answer.stage_count = static_cast<int32_t>(count);
  names.clear();
  for (std::size_t i = 0; i < count; ++i) names.emplace_back(s.stages[i].name);
  for (std::size_t i = 0; i < count; ++i) {
    const auto& [name, vf, ee, ve, vv] = s.stages[i];
    answer.stages[i] = {names[i].c_str(), {vf, ee, ve, vv}};
  }
  return answer;
}

}  // namespace tamis::c

using namespace tamis::c;

tamis_status tamis_weights_of(int32_t kind, double u, double v, double* weights) {
  Outcome outcome;
  return attempt(outcome, [&] {
    double* to = &required(weights, "weights");
    const std::array<double, 4> answer = tamis::weights_of(known_kind(kind), u, v);
    std::copy(answer.begin(), answer.end(), to);
  });
}
