// The order in which leaf blocks are searched when an early answer shortens the rest of the work.
#pragma once

namespace tamis {

struct Sample {
  int first, stride;
};

/// The leaf blocks in seven samples, each as large as all before it: an early contact found in a small one shortens
/// the step for the rest.
inline constexpr Sample kSamples[] = {{0, 64}, {32, 64}, {16, 32}, {8, 16}, {4, 8}, {2, 4}, {1, 2}};
inline constexpr Sample kAllBlocks[] = {{0, 1}};

/// Number of leaf blocks of `blocks` in a sample.
inline int count_in(const Sample& sample, int blocks) {
  return blocks > sample.first ? (blocks - sample.first + sample.stride - 1) / sample.stride : 0;
}

}  // namespace tamis
