// Samples of leaf blocks, searched one after the other. A contact in an early sample shortens the search of the rest.
#pragma once
#include <array>

namespace tamis {

/// Leaf blocks first, first + stride, ...; by default all of them.
struct Sample {
  int first = 0, stride = 1;

  int block(int i) const { return first + i * stride; }
  /// How many of `blocks` leaf blocks are in the sample.
  int count_in(int blocks) const { return blocks > first ? (blocks - first + stride - 1) / stride : 0; }
};

/// The leaf blocks in up to seven samples, each as large as all before it. An early contact found in a small one
/// shortens the step for the rest.
class Samples {
 public:
  /// All blocks at once.
  Samples() { add({}); }
  /// Up to kMostSamples samples of `blocks` leaf blocks. A sample has an overhead, so the first has at least
  /// kFewestBlocks.
  explicit Samples(int blocks) {
    int stride = 1 << (kMostSamples - 1);
    while (stride > 1 && blocks < kFewestBlocks * stride) stride /= 2;
    add({0, stride});
    for (; stride > 1; stride /= 2) add({stride / 2, stride});
  }

  const Sample* begin() const { return samples_.data(); }
  const Sample* end() const { return begin() + count_; }

 private:
  static constexpr int kMostSamples = 7, kFewestBlocks = 2;

  void add(const Sample& sample) { samples_[static_cast<std::size_t>(count_++)] = sample; }

  std::array<Sample, kMostSamples> samples_;
  int count_ = 0;
};

}  // namespace tamis
