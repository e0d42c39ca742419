#include "paths/pairs_on_parts.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "motion/time_clip.hpp"
#include "numerics/in_parts.hpp"
#include "paths/path_reader.hpp"
#include "query/cancellation.hpp"
#include "search/pair_buffer.hpp"
#include "topology/at.hpp"

namespace tamis {
namespace {

/// A part with no more pairs is not cut further: these are decided.
constexpr std::size_t kFewPairs = 4;
/// Deviations go by the square of the length, as on all paths here: they are then a million times smaller.
constexpr int kMostHalvingsOfPiece = 10;
/// Tests in lanes: so many cost less than the decision on one pair.
constexpr std::size_t kMostTestsPerPair = 64;

}  // namespace

void PairsOnParts::begin(const Piece& piece) {
  piece_.emplace(piece);
  number_vertices();
  std::vector<std::int32_t> all(piece.pairs.size());
  std::iota(all.begin(), all.end(), 0);
  tests_left_ = kMostTestsPerPair * all.size();
  is_given_.assign(all.size(), false);
  may_touch_.assign(all.size(), false);
  is_used_.assign(names_.size(), false);
  vertices_.resize(names_.size());
  parts_.clear();
  parts_.push_back({of_pairs(piece.from), of_pairs(piece.to), std::move(all), 0});
}

void PairsOnParts::number_vertices() {
  constexpr Index kUnused = -1, kUsed = 0;
  std::vector<Index> numbers(piece_->from.points.size(), kUnused);
  for (const Contact& pair : piece_->pairs)
    for (const Index v : pair.vertices)
      if (v >= 0) numbers[at(v)] = kUsed;
  names_.clear();
  for (std::size_t v = 0; v < numbers.size(); ++v) {
    if (numbers[v] == kUnused) continue;
    numbers[v] = static_cast<Index>(names_.size());
    names_.push_back(static_cast<Index>(v));
  }
  pairs_.clear();
  for (const Contact& pair : piece_->pairs) {
    PairVertices& numbered = pairs_.emplace_back(pair.vertices);
    for (Index& v : numbered)
      if (v >= 0) v = numbers[at(v)];
  }
}

std::shared_ptr<const MeshMoment> PairsOnParts::of_pairs(const MeshMoment& whole) const {
  MeshMoment moment{whole.time, {}, {}};
  for (const Index v : names_) {
    moment.points.push_back(whole.points[at(v)]);
    moment.errors.push_back(whole.errors[at(v)]);
  }
  return std::make_shared<const MeshMoment>(std::move(moment));
}

std::vector<std::int32_t> PairsOnParts::next(double latest) {
  while (!parts_.empty() && parts_.back().from->time <= latest) {
    Part part = std::move(parts_.back());
    parts_.pop_back();
    std::erase_if(part.pairs, [&](std::int32_t pair) { return is_given_[at(pair)]; });
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
  find_used(part.pairs);
  const auto middle = moment_at(near_middle(part.from->time, part.to->time));
  add_half(part, middle, part.to);
  add_half(part, part.from, middle);
}

void PairsOnParts::find_used(const std::vector<std::int32_t>& pairs) {
  for (const std::int32_t pair : pairs)
    for (const Index v : pairs_[at(pair)])
      if (v >= 0) is_used_[at(v)] = true;
  used_.clear();
  names_used_.clear();
  for (std::size_t v = 0; v < is_used_.size(); ++v)
    if (std::exchange(is_used_[v], false)) {
      used_.push_back(static_cast<Index>(v));
      names_used_.push_back(names_[v]);
    }
}

std::shared_ptr<const MeshMoment> PairsOnParts::moment_at(double time) const {
  std::vector<Point> points(used_.size());
  std::vector<double> errors(used_.size());
  piece_->path.points_at(time, names_used_, points, errors);
  MeshMoment moment{time, std::vector<Point>(is_used_.size()), std::vector<double>(is_used_.size())};
  for (std::size_t i = 0; i < used_.size(); ++i) {
    check_point(names_used_[i], time, points[i], errors[i]);
    moment.points[at(used_[i])] = points[i];
    moment.errors[at(used_[i])] = errors[i];
  }
  return std::make_shared<const MeshMoment>(std::move(moment));
}

/// REQUIRES: used_ of the pairs of `whole`.
void PairsOnParts::add_half(const Part& whole, std::shared_ptr<const MeshMoment> from,
                            std::shared_ptr<const MeshMoment> to) {
  deviations_.resize(used_.size());
  piece_->path.deviations(from->time, to->time, names_used_, deviations_);
  for (std::size_t i = 0; i < used_.size(); ++i) {
    const std::size_t v = at(used_[i]);
    check_deviation(names_used_[i], from->time, to->time, deviations_[i]);
    const Point &p = from->points[v], &q = to->points[v];
    const double error = std::max(from->errors[v], to->errors[v]);
    const double radius = chord_radius(names_used_[i], deviations_[i], error, from->time, piece_->separations);
    vertices_[v] = {{p[0], p[1], p[2], radius, q[0], q[1], q[2], 0}};
  }
  for (std::size_t kind = 0; kind < kPairKinds; ++kind) {
    std::vector<std::int32_t> of_kind;
    std::ranges::copy_if(whole.pairs, std::back_inserter(of_kind), [&](std::int32_t pair) {
      return static_cast<std::size_t>(piece_->pairs[at(pair)].kind) == kind;
    });
    in_parts(of_kind.size(), std::size_t{PairBuffer::kCapacity / 2}, [&](std::size_t first, std::size_t last) {
      for (; first < last; first += PairBuffer::kCapacity)
        test(static_cast<PairKind>(kind),
             std::span(of_kind).subspan(first, std::min<std::size_t>(last - first, PairBuffer::kCapacity)));
    });
  }
  Part half{std::move(from), std::move(to), {}, whole.halvings + 1};
  std::ranges::copy_if(whole.pairs, std::back_inserter(half.pairs),
                       [&](std::int32_t pair) { return std::exchange(may_touch_[at(pair)], false); });
  if (!half.pairs.empty()) parts_.push_back(std::move(half));
}

void PairsOnParts::test(PairKind kind, std::span<const std::int32_t> pairs) {
  Scratch& scratch = *scratch_.local();
  PairBuffer& buffer = scratch.pairs;
  buffer.count = static_cast<int>(pairs.size());
  for (int i = 0; i < buffer.count; ++i) put(kind, pairs_[at(pairs[at(i)])], buffer, i);
  const WithinRule rule{{piece_->separations.fixed, true}, 1};
  const int left = kernels_.of(kind).come_within(vertices_.data(), rule, buffer, scratch.within, scratch.solved.data());
  for (int i = 0; i < left; ++i) may_touch_[at(pairs[at(scratch.solved[at(i)].pair)])] = true;
}

}  // namespace tamis
