#include "engines/tamis/near_pipeline.hpp"

#include <cmath>
#include <limits>

#include "engines/cancellation.hpp"
#include "engines/tamis/pair_buffers.hpp"
#include "numerics/assert.hpp"
#include "numerics/error_bounds.hpp"

namespace tamis {
namespace {

float rounded_up(double x) { return std::nextafter(static_cast<float>(x), std::numeric_limits<float>::infinity()); }

}  // namespace

NearRule NearQuestion::near() const {
  TAMIS_ASSERT(0 < fraction && fraction < 1);
  const double until = earliest.load(std::memory_order_relaxed) * (1 + 0x1p-15);
  return {rounded_up(fraction), rounded_up(until / (1 - fraction)), rounded_up(until), spread, reserve_bounds(until)};
}

/// (stretch - fraction) reserve <= until way + room + (1 - stretch) separation; without gradients this is what speed
/// alone allows, of which single pairs know no less.
ReserveBounds NearQuestion::reserve_bounds(double until) const {
  constexpr double kShare = 0.25;  // (x + y + z)^2 <= (1 + kShare) x^2 + 2 (1 + 1 / kShare) (y^2 + z^2)
  const double left = stretch.least - fraction, reach = until / left;
  const float stretch2 = rounded_up(stretch.greatest * stretch.greatest);
  if (!stretch.is_any) return {rounded_up(reach * reach), 0, 0, stretch2};
  const double room = error_bounds::kRoomOfBoxes / left, apart = (1 - stretch.least) * separation / left;
  return {rounded_up((1 + kShare) * reach * reach), rounded_up(4 * (1 + 1 / kShare) * room * room),
          rounded_up(2 * (1 + 1 / kShare) * apart * apart), stretch2};
}

NearCounts& NearCounts::operator+=(const NearCounts& other) {
  add(boxes, other.boxes);
  add(near, other.near);
  decided_by.scalar += other.decided_by.scalar;
  decided_by.exact += other.decided_by.exact;
  nodes_visited += other.nodes_visited;
  traverse += other.traverse;
  filter += other.filter;
  solving += other.solving;
  return *this;
}

struct NearPipeline::Buffers {
  PairBuffer boxes, near;
  PairKind kind = PairKind::vertex_face;
};

NearPipeline::NearPipeline(const Kernels& kernels, const PackedMotion& motion, const Options& options,
                           NearQuestion& question)
    : kernels_(kernels),
      motion_(motion),
      options_(options),
      question_(question),
      buffers_(std::make_unique<Buffers>()) {}

NearPipeline::~NearPipeline() = default;
NearPipeline::NearPipeline(NearPipeline&&) noexcept = default;

void NearPipeline::begin() {
  buffers_->boxes.count = 0;  // pairs of a step whose question threw
  limit_ = {};
  ends_.clear();
  counts_ = {};
}

std::uint64_t NearPipeline::memory_bytes() const { return sizeof(Buffers) + ends_.capacity() * sizeof(StepLimit); }

void NearPipeline::search(PairKind kind, const TreeView& a, const TreeView& b, int first, int last, int stride) {
  watch_.lap();
  buffers_->kind = kind;
  Search search{a, b};
  search.near = question_.near();
  search.pairs = &buffers_->boxes;
  search.flush = flush;
  search.context = this;
  const auto kernel = kernels_.of(kind).search_near;
  for (int block = first; block < last; block += stride) search_block(kernel, search, block);
  counts_.nodes_visited += search.nodes_visited;
  counts_.traverse += watch_.lap();
  decide_buffered();
}

void NearPipeline::flush(Search& search) {
  auto& self = *static_cast<NearPipeline*>(search.context);
  self.counts_.traverse += self.watch_.lap();
  self.decide_buffered();
  search.near = self.question_.near();
}

void NearPipeline::decide_buffered() {
  stop_if_cancelled(options_);
  PairBuffer &boxes = buffers_->boxes, &near = buffers_->near;
  const PairKind kind = buffers_->kind;
  keep_each_once(kind, boxes);
  near.count = 0;
  of(counts_.boxes, kind) += static_cast<std::uint64_t>(boxes.count);
  if (can_cross(kind)) {
    const NearVertices vertices{motion_.box_vertices.data(), motion_.box_separation(), motion_.vertices.data(),
                                motion_.pair_separation()};
    kernels_.of(kind).near(vertices, question_.near(), boxes, near);
  }
  const PairBuffer& left = can_cross(kind) ? near : boxes;  // loose points are few
  of(counts_.near, kind) += static_cast<std::uint64_t>(left.count);
  counts_.filter += watch_.lap();
  for (int i = 0; i < left.count; ++i) decide(vertices_of(kind, left, i));
  boxes.count = 0;
  counts_.solving += watch_.lap();
}

void NearPipeline::decide(const PairVertices& vertices) {
  stop_if_cancelled(options_);
  const PairKind kind = buffers_->kind;
  if (limit_.rules_out(kind, vertices) || !lets_pass(options_.filter, kind, vertices)) return;
  double earliest = question_.earliest.load(std::memory_order_relaxed);
  const double until = std::nextafter(earliest, 2.0);  // a tie is of interest too
  const double time = keeps_distance_until(kind, points_of(question_.step, vertices),
                                           {question_.fraction, motion_.separations.between(kind, vertices)}, until,
                                           counts_.decided_by);
  if (time > earliest) return;
  if (question_.lists_all) {
    if (time < 1) ends_.push_back({time, kind, vertices});
    return;
  }
  limit_.add({time, kind, vertices});
  while (time < earliest && !question_.earliest.compare_exchange_weak(earliest, time, std::memory_order_relaxed)) {
  }
}

}  // namespace tamis
