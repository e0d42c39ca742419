// One thread's part of a search for near pairs: a small buffer of pairs whose boxes meet, and what is near of them.
#pragma once
#include <array>
#include <memory>
#include <vector>

#include "engines/pair_rules.hpp"
#include "engines/stopwatch.hpp"
#include "kernels/kernels.hpp"
#include "tamis/near.hpp"
#include "tamis/statistics.hpp"

namespace tamis {

class NearFinder {
 public:
  /// Keeps references.
  NearFinder(const Kernels& kernels, const PackedMotion& motion, const Options& options);
  ~NearFinder();
  NearFinder(NearFinder&&) noexcept;

  /// Forgets the last question; the memory stays.
  void begin(const Step& step);
  /// Leaf blocks first .. last of `a` against all of `b`.
  void search(PairKind kind, const TreeView& a, const TreeView& b, int first, int last);
  /// What is to be said of pairs that were found, in their order.
  void describe(PairKind kind, const Step& step, const PairVertices* pairs, std::size_t count, NearPair* out);
  std::uint64_t memory_bytes() const;

  std::array<std::vector<PairVertices>, kPairKinds> found;  ///< [kind], in no order
  StageCount boxes{"boxes"}, near{"near"};
  PrecisionCount decided_by;
  std::uint64_t nodes_visited = 0;
  double traverse = 0, solving = 0;  ///< seconds

 private:
  struct Buffers;

  static void flush(Search& search);
  void decide_buffered();
  void keep(PairBuffer& pairs);

  const Kernels& kernels_;
  const PackedMotion& motion_;
  const Options& options_;
  Step step_;
  std::unique_ptr<Buffers> buffers_;
  Stopwatch watch_;
};

}  // namespace tamis
