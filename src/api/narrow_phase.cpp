#include <algorithm>
#include <atomic>
#include <string>
#include <vector>

#include "api/list_part.hpp"
#include "api/pair_faults.hpp"
#include "api/validate.hpp"
#include "numbers/finite.hpp"
#include "numbers/floating_point_state.hpp"
#include "numbers/parallel.hpp"
#include "search/query/cancellation.hpp"
#include "tamis/error.hpp"
#include "tamis/pair.hpp"

namespace tamis {
namespace {

[[noreturn]] void refuse_first_fault(std::span<const FeaturePair> pairs, const Step& step) {
  for (std::size_t i = 0;; ++i)
    if (const std::string fault = fault_of(pairs[i], step); !fault.empty())
      throw InvalidStep("pair " + std::to_string(i) + ": " + fault);
}

[[noreturn]] void refuse_first_point(std::size_t corners, std::span<const Point> start, std::span<const Point> end) {
  for (std::size_t i = 0;; ++i)
    for (const auto& [points, when] : {std::pair(start, "start"), std::pair(end, "end")})
      if (!is_finite(points[i].data()))
        throw InvalidStep("pair " + std::to_string(i / corners) + ": " + not_finite(i % corners, when));
}

void validate(std::span<const FeaturePair> pairs, const Step& step, std::span<PairResult> results) {
  if (results.size() != pairs.size())
    throw InvalidStep("there are " + std::to_string(pairs.size()) + " pairs and " + std::to_string(results.size()) +
                      " results: give as many results as pairs");
  validate_layout(step);
}

void validate(PairKind kind, std::span<const Point> start, std::span<const Point> end, std::span<PairResult> results) {
  if (!is_kind(kind)) throw InvalidStep(no_such_kind(kind));
  const std::size_t needed = vertex_count(kind) * results.size();
  if (start.size() == needed && end.size() == needed) return;
  throw InvalidStep(std::to_string(results.size()) + " pairs of kind " + std::string(name_of(kind)) + " have " +
                    std::to_string(needed) + " points, there are " + std::to_string(start.size()) +
                    " at the start and " + std::to_string(end.size()) + " at the end of the step: give as many");
}

constexpr std::size_t kPairsOfListPart = 8192;

struct PairsInStep {
  std::span<const FeaturePair> pairs;
  Step step;
};

/// Decides the pairs of part(first, count) for the parts of a list. Returns false if a pair is not legal.
template <class Part>
bool decide_in_parts(std::span<PairResult> results, const PairOptions& options, const Part& part_of) {
  const ComputingState state;
  validate(options);
  const Kernels& chosen = kernels(options.isa);
  std::atomic<bool> is_legal{true};
  const auto decide_part = [&](std::size_t first) {
    stop_if_cancelled(options);
    const std::size_t count = std::min(kPairsOfListPart, results.size() - first);
    const auto [pairs, step] = part_of(first, count);
    if (!decide_part_of_list({pairs, step, chosen, options}, results.subspan(first, count))) is_legal = false;
  };
  Arena(options).run([&] {
    parallel_for((results.size() + kPairsOfListPart - 1) / kPairsOfListPart, 1, [&](std::size_t i, std::size_t end) {
      for (; i != end; ++i) decide_part(i * kPairsOfListPart);
    });
  });
  return is_legal;
}

/// Pairs that have their own points, one pair's behind the other's.
std::vector<FeaturePair> pairs_in_a_row(PairKind kind, std::size_t count) {
  std::vector<FeaturePair> pairs(count);
  const auto corners = static_cast<Index>(vertex_count(kind));
  for (Index first = 0; FeaturePair & pair : pairs) {
    pair = {kind, {first, first + 1, first + 2, first + 3}};
    first += corners;
  }
  return pairs;
}

}  // namespace

void narrow_phase(std::span<const FeaturePair> pairs, const Step& step, std::span<PairResult> results,
                  const PairOptions& options) {
  validate(pairs, step, results);
  const auto part = [&](std::size_t first, std::size_t count) {
    return PairsInStep{pairs.subspan(first, count), step};
  };
  if (!decide_in_parts(results, options, part)) refuse_first_fault(pairs, step);
}

std::vector<PairResult> narrow_phase(std::span<const FeaturePair> pairs, const Step& step, const PairOptions& options) {
  std::vector<PairResult> results(pairs.size());
  narrow_phase(pairs, step, results, options);
  return results;
}

void narrow_phase(PairKind kind, std::span<const Point> start, std::span<const Point> end,
                  std::span<PairResult> results, const PairOptions& options) {
  validate(kind, start, end, results);
  const std::size_t corners = vertex_count(kind);
  const std::vector<FeaturePair> pairs =
      pairs_in_a_row(kind, std::min(results.size(), kPairsOfListPart));  // of each part
  const auto part = [&](std::size_t first, std::size_t count) {
    const Step step{start.subspan(corners * first, corners * count), end.subspan(corners * first, corners * count)};
    return PairsInStep{std::span(pairs).first(count), step};
  };
  if (!decide_in_parts(results, options, part)) refuse_first_point(corners, start, end);
}

}  // namespace tamis
