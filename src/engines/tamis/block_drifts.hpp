// How far vertices have moved since some time before, block by block, and against each other.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "bounds/packed_motion.hpp"
#include "bvh/block_tree.hpp"

namespace tamis {

/// The drifts of a motion, bounded for the leaf blocks of one tree.
class BlockDrifts {
 public:
  /// Of this tree, until it is built anew.
  void set_blocks(const TreeView& tree, std::size_t vertex_count);
  /// From the drifts that `motion` has now.
  void count(const PackedMotion& motion);

  /// One box a leaf block: its vertices' drifts at t=0 and at t=1.
  std::span<const MovingBox> boxes() const { return boxes_; }
  std::uint64_t memory_bytes() const;

 private:
  std::vector<std::size_t> first_;  ///< of each block in vertices_, and the end
  std::vector<Index> vertices_;     ///< of each block, each once
  std::vector<MovingBox> boxes_;
};

/// The drifts of some vertices of a motion, one at least.
MovingBox drifts_of(const PackedMotion& motion, std::span<const Index> vertices);

/// Bounds, in the unit of the boxes, of how far points of two blocks have moved against each other since drifts are
/// counted, at both ends of the step; what they have in common cancels.
struct RelativeDrift {
  float at_start, at_end;

  RelativeDrift(const MovingBox& a, const MovingBox& b);
  /// At any time until t: positions are linear in time, so a distance of two of them is convex.
  float until(float t) const;
};

}  // namespace tamis
