#include "bvh/group_order.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "bounds/box.hpp"

namespace tamis {
namespace {

/// Where this many groups lie in one place, blocks of one group each are so large that they meet more blocks of others
/// than blocks by place alone meet in all: some nine of each group, of 27.
constexpr std::size_t kMostAtOnePlace = 3;

/// Do more groups than pay lie in the place of one feature, in the mean? By some features, and the groups' boxes.
bool lie_in_each_other(std::span<const GroupedFeature> features, std::size_t group_count) {
  constexpr std::size_t kSampleFeatures = 64;
  const auto point_of = [](const GroupedFeature& feature) {
    return Point{feature.at[0], feature.at[1], feature.at[2]};
  };
  std::vector<Box> boxes(group_count);
  for (const GroupedFeature& feature : features)
    boxes[static_cast<std::size_t>(feature.group)].include(point_of(feature));
  std::size_t asked = 0, found = 0;
  for (std::size_t i = 0; i < features.size(); i += 1 + features.size() / kSampleFeatures, ++asked) {
    Box here;
    here.include(point_of(features[i]));
    for (const Box& box : boxes) found += may_meet(box, here);
  }
  return found > kMostAtOnePlace * asked;
}

/// The groups that are apart, of those that have features, as their middles lie in space.
std::vector<Index> apart_in_space(std::span<const GroupedFeature> features, std::span<const std::uint8_t> is_apart,
                                  Split split) {
  constexpr std::size_t kSpace = 3;
  std::vector<std::array<float, kSpace>> sums(is_apart.size());
  std::vector<float> counts(is_apart.size());
  for (const auto& [of, at] : features) {
    const auto group = static_cast<std::size_t>(of);
    for (std::size_t k = 0; k < kSpace; ++k) sums[group][k] += at[k];
    ++counts[group];
  }
  std::vector<Index> apart;
  for (std::size_t group = 0; group < is_apart.size(); ++group)
    if (is_apart[group] && counts[group] > 0) apart.push_back(static_cast<Index>(group));
  CenterStore store(apart.size(), kSpace);
  const Centers middles = store.view();
  for (std::size_t i = 0; i < apart.size(); ++i) {
    const auto group = static_cast<std::size_t>(apart[i]);
    for (std::size_t k = 0; k < kSpace; ++k) middles.at[k][i] = sums[group][k] / counts[group];
    middles.feature[i] = apart[i];
  }
  order_in_space(middles, apart.size(), split, [] {});
  return {store.features().begin(), store.features().end()};
}

}  // namespace

GroupOrder order_groups(std::span<const GroupedFeature> features, std::span<const std::uint8_t> is_apart, Split split) {
  if (lie_in_each_other(features, is_apart.size())) return {};
  std::vector<std::size_t> rank(is_apart.size(), 0);  // those that touch themselves come first
  std::size_t last = 0;
  for (const Index group : apart_in_space(features, is_apart, split)) rank[static_cast<std::size_t>(group)] = ++last;
  GroupOrder order{std::vector<Index>(features.size()), std::vector<std::size_t>(last + 1)};
  const auto rank_of = [&](const GroupedFeature& feature) { return rank[static_cast<std::size_t>(feature.group)]; };
  // A counting sort: `ends` are counts, then where each group begins, and as features are put there, where it ends.
  for (const GroupedFeature& feature : features) ++order.ends[rank_of(feature)];
  std::size_t begin = 0;
  for (std::size_t& end : order.ends) begin += std::exchange(end, begin);
  for (std::size_t i = 0; i < features.size(); ++i)
    order.features[order.ends[rank_of(features[i])]++] = static_cast<Index>(i);
  return order;
}

}  // namespace tamis
