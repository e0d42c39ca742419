// Samples of leaf blocks: searched one after the other, so that what an early one finds shortens the search of the
// rest.
#pragma once
#include <vector>

namespace tamis {

/// Leaf blocks first, first + stride, ...: by default all of them.
struct Sample {
  int first = 0, stride = 1;

  /// How many of `blocks` leaf blocks are in the sample.
  int count_in(int blocks) const { return blocks > first ? (blocks - first + stride - 1) / stride : 0; }
};

/// All leaf blocks in up to seven samples, each as large as all before it: an early contact found in a small one
/// shortens the step for the rest. A sample has an overhead, so the first has at least two blocks; fewer are all in it.
inline std::vector<Sample> samples_of(int blocks) {
  constexpr int kMostSamples = 7, kFewestBlocks = 2;
  int stride = 1 << (kMostSamples - 1);
  while (stride > 1 && blocks < kFewestBlocks * stride) stride /= 2;
  std::vector<Sample> samples{{0, stride}};
  for (; stride > 1; stride /= 2) samples.push_back({stride / 2, stride});
  return samples;
}

}  // namespace tamis
