#include "search/bvh/group_order.hpp"

#include <array>

#include "numbers/counting_sort.hpp"
#include "search/bounds/box.hpp"

namespace tamis {
namespace {

/// Where more groups than this overlap at one place, blocks of one group each are large. They meet more blocks of other
/// groups than blocks ordered by place alone meet in all.
constexpr std::size_t kMostAtOnePlace = 3;

/// True if a feature is inside the boxes of more than kMostAtOnePlace groups, on average over a sample.
bool overlap_much(std::span<const GroupedFeature> features, std::size_t group_count) {
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

/// The groups without self-contact that have features, ordered by their centers in space.
std::vector<Index> groups_in_space_order(std::span<const GroupedFeature> features,
                                         std::span<const std::uint8_t> no_self_contact) {
  constexpr std::size_t kSpace = 3;
  std::vector<std::array<float, kSpace>> sums(no_self_contact.size());
  std::vector<float> counts(no_self_contact.size());
  for (const auto& [of, at] : features) {
    const auto group = static_cast<std::size_t>(of);
    for (std::size_t k = 0; k < kSpace; ++k) sums[group][k] += at[k];
    ++counts[group];
  }
  std::vector<Center<kSpace>> middles;
  for (std::size_t group = 0; group < no_self_contact.size(); ++group) {
    if (!no_self_contact[group] || counts[group] == 0) continue;
    const auto& [x, y, z] = sums[group];
    const float count = counts[group];
    middles.push_back({{x / count, y / count, z / count}, static_cast<Index>(group)});
  }
  order_in_space<kSpace>(middles, [] {});
  std::vector<Index> groups;
  for (const auto& middle : middles) groups.push_back(middle.feature);
  return groups;
}

}  // namespace

GroupOrder order_groups(std::span<const GroupedFeature> features, std::span<const std::uint8_t> no_self_contact) {
  if (overlap_much(features, no_self_contact.size())) return {};
  std::vector<std::size_t> rank(no_self_contact.size(), 0);  // groups that touch themselves come first
  std::size_t last = 0;
  for (const Index group : groups_in_space_order(features, no_self_contact))
    rank[static_cast<std::size_t>(group)] = ++last;
  GroupOrder order{std::vector<Index>(features.size()), std::vector<std::size_t>(last + 1)};
  CountingSort sort;
  sort.find_places(
      features.size(), order.ends.size(),
      [&](std::size_t i) { return rank[static_cast<std::size_t>(features[i].group)]; },
      [&](std::size_t i, std::uint32_t place) { order.features[place] = static_cast<Index>(i); }, [] {});
  for (std::size_t group = 0; group <= last; ++group) order.ends[group] = sort.end_of(group);
  return order;
}

}  // namespace tamis
