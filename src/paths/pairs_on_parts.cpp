#include "paths/pairs_on_parts.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "motion/pair_kinds.hpp"
#include "numerics/in_parts.hpp"
#include "paths/path_reader.hpp"
#include "query/cancellation.hpp"
#include "topology/at.hpp"

namespace tamis {
namespace {

/// So few are decided at once.
constexpr std::size_t kFewPairs = 4;
/// Where deviations go by squares of lengths, as of all paths here, they have become smaller by a million.
constexpr int kMostHalvingsOfAPiece = 10;
/// A pair that is looked at in lanes so often has cost a part of what its decision does.
constexpr std::size_t kMostLooksAPair = 64;

}  // namespace

void PairsOnParts::begin(const Piece& piece) {
  piece_.emplace(piece);
  const auto whole = [](const Frame& frame) { return std::shared_ptr<const Frame>(std::shared_ptr<void>(), &frame); };
  std::vector<std::int32_t> all(piece.pairs.size());
  std::iota(all.begin(), all.end(), 0);
  looks_left_ = kMostLooksAPair * all.size();
  is_given_.assign(all.size(), false);
  may_touch_.assign(all.size(), false);
  is_used_.assign(piece.from.points.size(), false);
  vertices_.resize(piece.from.points.size());
  parts_.clear();
  parts_.push_back({whole(piece.from), whole(piece.to), std::move(all), 0});
}

std::vector<std::int32_t> PairsOnParts::next(double latest) {
  while (!parts_.empty() && parts_.back().from->time <= latest) {
    Part part = std::move(parts_.back());
    parts_.pop_back();
    std::erase_if(part.pairs, [&](std::int32_t pair) { return is_given_[at(pair)]; });
    if (part.pairs.empty()) continue;
    if (part.pairs.size() > kFewPairs && part.halvings < kMostHalvingsOfAPiece &&
        looks_left_ >= 2 * part.pairs.size()) {
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
  looks_left_ -= 2 * part.pairs.size();
  find_used(part.pairs);
  const auto middle = frame_at(near_middle(part.from->time, part.to->time));
  add_half(part, middle, part.to);
  add_half(part, part.from, middle);
}

void PairsOnParts::find_used(const std::vector<std::int32_t>& pairs) {
  for (const std::int32_t pair : pairs)
    for (const Index v : piece_->pairs[at(pair)].vertices)
      if (v >= 0) is_used_[at(v)] = true;
  used_.clear();
  for (std::size_t v = 0; v < is_used_.size(); ++v)
    if (is_used_[v]) used_.push_back(static_cast<Index>(v));
  for (const Index v : used_) is_used_[at(v)] = false;
}

std::shared_ptr<const Frame> PairsOnParts::frame_at(double time) const {
  std::vector<Point> points(used_.size());
  std::vector<double> errors(used_.size());
  piece_->path.points_at(time, used_, points, errors);
  Frame frame{time, std::vector<Point>(is_used_.size()), std::vector<double>(is_used_.size())};
  for (std::size_t i = 0; i < used_.size(); ++i) {
    check_point(used_[i], time, points[i], errors[i]);
    frame.points[at(used_[i])] = points[i];
    frame.errors[at(used_[i])] = errors[i];
  }
  return std::make_shared<const Frame>(std::move(frame));
}

/// REQUIRES: used_ of the pairs of `whole`.
void PairsOnParts::add_half(const Part& whole, std::shared_ptr<const Frame> from, std::shared_ptr<const Frame> to) {
  deviations_.resize(used_.size());
  piece_->path.deviations(from->time, to->time, used_, deviations_);
  for (std::size_t i = 0; i < used_.size(); ++i) {
    const Index v = used_[i];
    check_deviation(v, from->time, to->time, deviations_[i]);
    const Point &p = from->points[at(v)], &q = to->points[at(v)];
    const double radius = radius_on_piece(v, deviations_[i], *from, *to, piece_->separations);
    vertices_[at(v)] = {{p[0], p[1], p[2], radius, q[0], q[1], q[2], 0}};
  }
  for (std::size_t kind = 0; kind < kPairKinds; ++kind) {
    std::vector<std::int32_t> of_kind;
    std::ranges::copy_if(whole.pairs, std::back_inserter(of_kind), [&](std::int32_t pair) {
      return static_cast<std::size_t>(piece_->pairs[at(pair)].kind) == kind;
    });
    in_parts(of_kind.size(), std::size_t{PairBuffer::kCapacity / 2}, [&](std::size_t first, std::size_t last) {
      for (; first < last; first += PairBuffer::kCapacity)
        look(static_cast<PairKind>(kind),
             std::span(of_kind).subspan(first, std::min<std::size_t>(last - first, PairBuffer::kCapacity)));
    });
  }
  Part half{std::move(from), std::move(to), {}, whole.halvings + 1};
  std::ranges::copy_if(whole.pairs, std::back_inserter(half.pairs),
                       [&](std::int32_t pair) { return std::exchange(may_touch_[at(pair)], false); });
  if (!half.pairs.empty()) parts_.push_back(std::move(half));
}

void PairsOnParts::look(PairKind kind, std::span<const std::int32_t> pairs) {
  Scratch& scratch = scratch_.local();
  PairBuffer& buffer = scratch.pairs;
  buffer.count = static_cast<int>(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const PairVertices& v = piece_->pairs[at(pairs[i])].vertices;
    for (std::size_t c = 0; c < vertex_count(kind); ++c) buffer.corner[c][i] = v[c];
  }
  const WithinRule rule{{piece_->separations.fixed, true}, 1};
  const int left = kernels_.of(kind).come_within(vertices_.data(), rule, buffer, scratch.within, scratch.solved.get());
  for (int i = 0; i < left; ++i) may_touch_[at(pairs[at(scratch.solved[at(i)].pair)])] = true;
}

}  // namespace tamis
