// The pairs that may touch on a piece of a path are tested again on its halves, the earlier first, then on halves of
// these. Chords of shorter parts deviate less. Lanes test hundreds of pairs in the time that one decision on curves
// takes.
#pragma once
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "curves/paths/mesh_moment.hpp"
#include "numbers/pool.hpp"
#include "numbers/raw_array.hpp"
#include "search/kernels/kernels.hpp"
#include "search/query/pair_vertices.hpp"
#include "tamis/path.hpp"

namespace tamis {

class PairsOnParts {
 public:
  explicit PairsOnParts(const Kernels& kernels) : kernels_(kernels) {}

  struct Piece {
    const Path& path;
    Separations separations;         ///< PathSearch::searched_
    std::span<const Contact> pairs;  ///< those that chords of the whole piece do not prove free
    const MeshMoment &from, &to;
    const std::function<bool()>& is_cancelled;
  };
  /// Keeps the piece's references until the next call.
  void begin(const Piece& piece);

  /// True if a pair that is apart before this time is still wanted. Once it is not, it is not for later times.
  using Wants = std::function<bool(const Contact& pair, double from)>;
  /// The places in Piece::pairs of the pairs to decide next, ascending. These may touch in the earliest part that has
  /// wanted pairs. Returns each pair once. Empty if no other pair is wanted. Throws InvalidPath and Cancelled.
  std::vector<std::int32_t> next(const Wants& wants);

 private:
  struct Part {
    std::vector<Index> vertices;  ///< of its pairs, ascending
    MeshMoment from, to;          ///< of these vertices alone
    std::vector<std::int32_t> pairs;
    int halvings;
  };
  struct Scratch {
    PairBuffer pairs;
    DecisionScratch scratch;
    DecisionRoom<PairBuffer::kCapacity> decisions;
  };

  /// `from` and `to` are moments of `vertices`, which hold the vertices of these pairs, and maybe others.
  Part part_of(const std::vector<Index>& vertices, const MeshMoment& from, const MeshMoment& to,
               std::vector<std::int32_t> pairs, int halvings);
  void halve(const Part& part);
  void add_half(const Part& whole, const MeshMoment& from, const MeshMoment& to);
  /// Tests pairs of one kind in lanes. Marks the pairs that may touch in the half in may_touch_.
  void test(PairKind kind, std::span<const std::int32_t> pairs);

  const Kernels& kernels_;
  std::optional<Piece> piece_;
  std::vector<Part> parts_;  ///< the earliest last
  std::size_t tests_left_ = 0;
  std::vector<char> is_given_, may_touch_;  ///< of each pair of the piece
  std::vector<Index> place_;                ///< of each vertex of the mesh among the vertices of a part
  std::vector<PackedVertex> vertices_;      ///< of a half; entries behind these are leftovers of other parts
  Pool<Scratch> scratch_{[](std::size_t) { return make_raw<Scratch>(); }};
};

}  // namespace tamis
