#include "curves/paths/pairs_on_parts.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "curves/paths/path_reader.hpp"
#include "numbers/in_parts.hpp"
#include "pair/motion/time_clip.hpp"
#include "search/query/cancellation.hpp"
#include "search/topology/at.hpp"

namespace tamis {
namespace {

/// A part with no more pairs than this is not cut further. Its pairs are decided.
constexpr std::size_t kFewPairs = 4;
/// Deviations go by the square of the length on all paths here. After 10 halvings they are a million times smaller.
constexpr int kMostHalvingsOfPiece = 10;
/// So many tests of a pair in lanes cost less than one decision on it.
constexpr std::size_t kMostTestsPerPair = 64;

}  // namespace

void PairsOnParts::begin(const Piece& piece) {
  piece_.emplace(piece);
  std::vector<std::int32_t> pairs(piece.pairs.size());
  std::iota(pairs.begin(), pairs.end(), 0);
  std::vector<Index> vertices(piece.from.points.size());
  std::iota(vertices.begin(), vertices.end(), 0);
  tests_left_ = kMostTestsPerPair * pairs.size();
  is_given_.assign(pairs.size(), false);
  may_touch_.assign(pairs.size(), false);
  place_.resize(vertices.size());
  parts_.clear();
  parts_.push_back(part_of(vertices, piece.from, piece.to, std::move(pairs), 0));
}

PairsOnParts::Part PairsOnParts::part_of(const std::vector<Index>& vertices, const MeshMoment& from,
                                         const MeshMoment& to, std::vector<std::int32_t> pairs, int halvings) {
  constexpr Index kUnused = -1, kUsed = 0;
  stop_if_cancelled(*piece_);
  for (const Index v : vertices) place_[at(v)] = kUnused;
  for (const std::int32_t pair : pairs)
    for (const Index v : piece_->pairs[at(pair)].vertices)
      if (v >= 0) place_[at(v)] = kUsed;
  std::vector<std::size_t> used;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    if (place_[at(vertices[i])] == kUsed) used.push_back(i);
  const auto used_of = [&used]<class T>(const std::vector<T>& all) {
    std::vector<T> some(used.size());
    for (std::size_t i = 0; i < used.size(); ++i) some[i] = all[used[i]];
    return some;
  };
  const auto at_time = [&](const MeshMoment& all) {
    return MeshMoment{all.time, used_of(all.points), used_of(all.errors)};
  };
  return {used_of(vertices), at_time(from), at_time(to), std::move(pairs), halvings};
}

std::vector<std::int32_t> PairsOnParts::next(const Wants& wants) {
  while (!parts_.empty()) {
    Part part = std::move(parts_.back());
    parts_.pop_back();
    std::erase_if(part.pairs, [&](std::int32_t pair) {
      return is_given_[at(pair)] || !wants(piece_->pairs[at(pair)], part.from.time);
    });
    if (part.pairs.empty()) continue;
    if (part.pairs.size() > kFewPairs && part.halvings < kMostHalvingsOfPiece && tests_left_ >= 2 * part.pairs.size()) {
      halve(part);
      continue;
    }
    for (const std::int32_t pair : part.pairs) is_given_[at(pair)] = true;
    return std::move(part.pairs);
  }
  return {};
}

void PairsOnParts::halve(const Part& part) {
  stop_if_cancelled(*piece_);
  tests_left_ -= 2 * part.pairs.size();
  const std::size_t count = part.vertices.size();
  MeshMoment middle{near_middle(part.from.time, part.to.time), std::vector<Point>(count), std::vector<double>(count)};
  piece_->path.points_at(middle.time, part.vertices, middle.points, middle.errors);
  for (std::size_t i = 0; i < count; ++i)
    check_point(part.vertices[i], middle.time, middle.points[i], middle.errors[i]);
  add_half(part, middle, part.to);
  add_half(part, part.from, middle);
}

void PairsOnParts::add_half(const Part& whole, const MeshMoment& from, const MeshMoment& to) {
  const std::vector<Index>& vertices = whole.vertices;
  std::vector<double> deviations(vertices.size());
  piece_->path.deviations(from.time, to.time, vertices, deviations);
  vertices_.resize(std::max(vertices_.size(), vertices.size()));
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Index v = vertices[i];
    check_deviation(v, from.time, to.time, deviations[i]);
    const Point &p = from.points[i], &q = to.points[i];
    const double error = std::max(from.errors[i], to.errors[i]);
    const double radius = chord_radius(v, deviations[i], error, from.time, piece_->separations);
    vertices_[i] = {{p[0], p[1], p[2], radius, q[0], q[1], q[2], 0}};
    place_[at(v)] = static_cast<Index>(i);
  }
  for (std::size_t kind = 0; kind < kPairKinds; ++kind) {
    std::vector<std::int32_t> of_kind;
    std::ranges::copy_if(whole.pairs, std::back_inserter(of_kind), [&](std::int32_t pair) {
      return static_cast<std::size_t>(piece_->pairs[at(pair)].kind) == kind;
    });
    constexpr std::size_t kPairsPerPart = 256;
    in_parts(of_kind.size(), kPairsPerPart, [&](std::size_t first, std::size_t last) {
      for (; first < last; first += PairBuffer::kCapacity) {
        stop_if_cancelled(*piece_);
        test(static_cast<PairKind>(kind),
             std::span(of_kind).subspan(first, std::min<std::size_t>(last - first, PairBuffer::kCapacity)));
      }
    });
  }
  std::vector<std::int32_t> left;
  std::ranges::copy_if(whole.pairs, std::back_inserter(left),
                       [&](std::int32_t pair) { return std::exchange(may_touch_[at(pair)], false); });
  if (!left.empty()) parts_.push_back(part_of(vertices, from, to, std::move(left), whole.halvings + 1));
}

void PairsOnParts::test(PairKind kind, std::span<const std::int32_t> pairs) {
  const auto taken = scratch_.take();
  Scratch& scratch = *taken;
  PairBuffer& buffer = scratch.pairs;
  buffer.count = static_cast<int>(pairs.size());
  for (int i = 0; i < buffer.count; ++i) {
    const PairVertices& vertices = piece_->pairs[at(pairs[at(i)])].vertices;
    for (std::size_t c = 0; c < vertex_count(kind); ++c) buffer.corner[c][i] = place_[at(vertices[c])];
  }
  const MotionView motion{vertices_.data(), {piece_->separations.fixed, true}};
  LaneDecisions decisions = scratch.decisions.lists();
  kernels_.of(kind).decide(motion, 1, buffer, scratch.scratch, decisions);
  for (int i = 0; i < decisions.touching_count; ++i) may_touch_[at(pairs[at(decisions.touching[i].pair)])] = true;
  for (int i = 0; i < decisions.undecided_count; ++i) may_touch_[at(pairs[at(decisions.undecided[i])])] = true;
}

}  // namespace tamis
