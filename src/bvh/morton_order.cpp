#include <algorithm>
#include <array>
#include <cstdint>

#include "bvh/block_tree.hpp"

namespace tamis {
namespace {

/// Spreads the low 10 bits to every third bit.
std::uint32_t spread(std::uint32_t x) {
  x = (x | (x << 16)) & 0x030000ffu;
  x = (x | (x << 8)) & 0x0300f00fu;
  x = (x | (x << 4)) & 0x030c30c3u;
  return (x | (x << 2)) & 0x09249249u;
}

std::uint32_t morton_code(const std::array<float, 3>& p) {
  std::uint32_t code = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float cell = std::clamp((p[axis] + 1.0f) * 512.0f, 0.0f, 1023.0f);
    code |= spread(static_cast<std::uint32_t>(cell)) << axis;
  }
  return code;
}

struct Item {
  std::uint32_t code;
  Index feature;
};

/// One stable counting pass over 15 bits.
void counting_pass(const std::vector<Item>& from, std::vector<Item>& to, unsigned shift) {
  constexpr std::uint32_t kBuckets = 1u << 15;
  std::vector<std::uint32_t> next(kBuckets + 1, 0);
  for (const Item& item : from) ++next[((item.code >> shift) & (kBuckets - 1)) + 1];
  for (std::size_t i = 0; i < kBuckets; ++i) next[i + 1] += next[i];
  for (const Item& item : from) to[next[(item.code >> shift) & (kBuckets - 1)]++] = item;
}

}  // namespace

std::vector<Index> morton_order(std::span<const std::array<float, 3>> centers) {
  std::vector<Item> items(centers.size()), scratch(centers.size());
  for (std::size_t i = 0; i < centers.size(); ++i) items[i] = {morton_code(centers[i]), static_cast<Index>(i)};
  counting_pass(items, scratch, 0);
  counting_pass(scratch, items, 15);
  std::vector<Index> order(centers.size());
  for (std::size_t i = 0; i < items.size(); ++i) order[i] = items[i].feature;
  return order;
}

}  // namespace tamis
