#include <tbb/parallel_for.h>

#include <atomic>
#include <string>

#include "detect/arena.hpp"
#include "detect/list_part.hpp"
#include "detect/pair_faults.hpp"
#include "detect/validate.hpp"
#include "numerics/finite.hpp"
#include "query/cancellation.hpp"
#include "tamis/error.hpp"
#include "tamis/pair.hpp"

namespace tamis {
namespace {

[[noreturn]] void refuse_first_fault(std::span<const Pair> pairs, const Step& step) {
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

void validate(std::span<const Pair> pairs, const Step& step, std::span<PairResult> results) {
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

/// `pairs_of(first, last)`: a part of the list. Returns false if some pair is not legal.
template <class PairsOf>
bool decide_in_parts(std::span<PairResult> results, const PairOptions& options, const PairsOf& pairs_of) {
  constexpr std::size_t kGrain = 8192;
  validate(options);
  const Kernels& chosen = kernels(options.isa);
  std::atomic<bool> is_legal{true};
  Arena(options.threads).run([&] {
    const tbb::blocked_range<std::size_t> all(0, results.size(), kGrain);
    const auto decide_part = [&](const tbb::blocked_range<std::size_t>& part) {
      stop_if_cancelled(options);
      const auto mine = pairs_of(part.begin(), part.end());
      if (!decide_part_of_list({mine.pairs, mine.step, chosen, options}, results.subspan(part.begin(), part.size())))
        is_legal = false;
    };
    tbb::parallel_for(all, decide_part, tbb::simple_partitioner());
  });
  return is_legal;
}

/// A list of pairs that have their own points, one pair's behind the other's.
struct OwnPairs {
  OwnPairs(PairKind kind, std::span<const Point> start, std::span<const Point> end)
      : pairs(start.size() / vertex_count(kind)), step{start, end} {
    const auto corners = static_cast<Index>(vertex_count(kind));
    for (Index first = 0; Pair & pair : pairs) {
      pair = {kind, {first, first + 1, first + 2, first + 3}};
      first += corners;
    }
  }

  std::vector<Pair> pairs;
  Step step;
};

struct PartOfList {
  std::span<const Pair> pairs;
  const Step& step;
};

}  // namespace

void narrow_phase(std::span<const Pair> pairs, const Step& step, std::span<PairResult> results,
                  const PairOptions& options) {
  validate(pairs, step, results);
  const bool is_legal = decide_in_parts(results, options, [&](std::size_t first, std::size_t last) {
    return PartOfList{pairs.subspan(first, last - first), step};
  });
  if (!is_legal) refuse_first_fault(pairs, step);
}

std::vector<PairResult> narrow_phase(std::span<const Pair> pairs, const Step& step, const PairOptions& options) {
  std::vector<PairResult> results(pairs.size());
  narrow_phase(pairs, step, results, options);
  return results;
}

void narrow_phase(PairKind kind, std::span<const Point> start, std::span<const Point> end,
                  std::span<PairResult> results, const PairOptions& options) {
  validate(kind, start, end, results);
  const std::size_t corners = vertex_count(kind);
  const bool is_legal = decide_in_parts(results, options, [&](std::size_t first, std::size_t last) {
    const std::size_t at = corners * first, count = corners * (last - first);
    return OwnPairs(kind, start.subspan(at, count), end.subspan(at, count));
  });
  if (!is_legal) refuse_first_point(corners, start, end);
}

}  // namespace tamis
