// The inputs of each stage for one step, so that each stage can be timed alone.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "pair/motion/make_motion.hpp"
#include "search/bounds/packed_motion.hpp"
#include "search/bvh/block_tree.hpp"
#include "search/kernels/kernels.hpp"
#include "tamis/detector.hpp"

namespace tamis::bench {

/// Contact means distance zero in all stages that are timed.
inline constexpr double kSeparation = 0;

using Buffers = std::vector<std::unique_ptr<PairBuffer>>;

/// Pairs of one kind as they enter each stage.
struct StageInputs {
  Buffers slab, filter, solve;
};

class Workload {
 public:
  Workload(std::string name, Mesh mesh, std::vector<Point> start, std::vector<Point> end);
  Workload(const Workload&) = delete;
  Workload& operator=(const Workload&) = delete;

  const std::string& name() const { return name_; }
  Step step() const { return {start_, end_}; }
  const Mesh& mesh() const { return mesh_; }
  const PackedMotion& motion() const { return motion_; }
  std::vector<BlockTree*> trees() { return {&points_, &edges_, &faces_}; }

  /// Searches the whole step. REQUIRES: `flush` empties the buffer it is given. Returns the number of nodes visited.
  template <class Flush>
  std::uint64_t search(PairKind kind, const Flush& flush) const {
    const bool is_vf = kind == PairKind::vertex_face;
    auto pairs = std::make_unique<PairBuffer>();
    Search search{is_vf ? points_.view() : edges_.view(), is_vf ? faces_.view() : edges_.view()};
    search.pairs = pairs.get();
    search.context = const_cast<void*>(static_cast<const void*>(&flush));
    search.flush = [](Search& s) { (*static_cast<const Flush*>(s.context))(*s.pairs); };
    for (int block = 0; block < search.a.leaf_blocks; ++block) kernels_.of(kind).search(search, block);
    flush(*pairs);
    return search.nodes_visited;
  }

  const StageInputs& inputs(PairKind kind) const { return kind == PairKind::vertex_face ? vf_ : ee_; }
  const Kernels& kernels() const { return kernels_; }
  /// The motions of the first `most` pairs of `buffers`, for the filters.
  std::vector<PairMotion<double>> motions(PairKind kind, const Buffers& buffers, std::size_t most) const;
  /// The points of the first `most` pairs of `buffers`, to decide them one by one.
  std::vector<PairPoints> points(const Buffers& buffers, std::size_t most) const;

 private:
  StageInputs inputs_of(PairKind kind) const;

  std::string name_;
  Mesh mesh_;
  std::vector<Point> start_, end_;
  const Kernels& kernels_;
  PackedMotion motion_;
  BlockTree points_, edges_, faces_;
  StageInputs vf_, ee_;
};

/// A generated cloth, and the recorded frames if they are there (TAMIS_DATA, or shared/data beside the project).
std::vector<std::unique_ptr<Workload>> make_workloads();

}  // namespace tamis::bench
