// Calls for the distance of single pairs, and for the time until which one keeps a fraction of it.
#include "tamis/pair_distance.hpp"

#include "c/answers.hpp"
#include "c/pairs.hpp"
#include "c/sized.hpp"
#include "c/step.hpp"

namespace tamis::c {
namespace {

/// The distance of a pair of a list; messages of exceptions name the pair.
NearPair distance_in_list(const std::vector<FeaturePair>& list, std::size_t i, const Positions& at) {
  try {
    return distance_of(list[i], at);
  } catch (const InvalidStep& fault) {
    throw InvalidStep("pair " + std::to_string(i) + ": " + fault.what());
  }
}

}  // namespace
}  // namespace tamis::c

using namespace tamis::c;

tamis_status tamis_distances_of(tamis_pairs* pairs, const tamis_feature_pair* list, size_t count,
                                const tamis_step* step, tamis_near_pair* answers, size_t answer_size) {
  return with_object(pairs, [&](const tamis::PairOptions&) {
    const tamis_step given = read_sized(step, "step");
    const tamis::Positions at = positions(given.start, given.vertex_count, given.start_stride, "start");
    const auto listed = list_of(list, count);
    if (count == 0) return;
    required(answers, "answers");
    check_size(answer_size, sizeof(int32_t), "answer");
    for (std::size_t i = 0; i < count; ++i)
      write_element(near_pair_of(distance_in_list(listed, i, at)), answers, i, answer_size);
  });
}

tamis_status tamis_pair_safe_step(tamis_pairs* pairs, const tamis_feature_pair* pair, const tamis_step* step,
                                  double keep, tamis_safe_step* answer) {
  return with_object(pairs, [&](const tamis::PairOptions& own) {
    write_sized(tamis_safe_step{}, answer, "answer");  // refuses a bad `answer` before the work
    const tamis_step given = read_sized(step, "step");
    const tamis::PairOptions options = options_for(given, own);
    const tamis::FeaturePair asked = pair_of(required(pair, "pair"));
    write_sized(answer_of(tamis::safe_step(asked, step_of(given), keep, options)), answer, "answer");
  });
}
