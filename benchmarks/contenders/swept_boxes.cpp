#include "benchmarks/contenders/swept_boxes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>

namespace tamis::bench {
namespace {

float round_down(double x) {
  const auto f = static_cast<float>(x);
  return static_cast<double>(f) <= x ? f : std::nextafter(f, -std::numeric_limits<float>::infinity());
}
float round_up(double x) { return -round_down(-x); }

SweptBox box_of(const Task& task, std::span<const Index> vertices) {
  SweptBox box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Index vertex : vertices)
      for (const std::vector<Point>* at : {&task.start, &task.end}) {
        const double x = (*at)[static_cast<std::size_t>(vertex)][axis];
        low = std::min(low, x);
        high = std::max(high, x);
      }
    box.low[axis] = round_down(low);
    box.high[axis] = round_up(high);
  }
  return box;
}

bool meet(const SweptBox& a, const SweptBox& b) {
  for (int axis = 0; axis < 3; ++axis)
    if (a.low[axis] > b.high[axis] || b.low[axis] > a.high[axis]) return false;
  return true;
}

std::vector<std::uint32_t> by_low_x(const std::vector<SweptBox>& boxes) {
  std::vector<std::uint32_t> order(boxes.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](auto i, auto j) { return boxes[i].low[0] < boxes[j].low[0]; });
  return order;
}

/// Calls f(i, j) for boxes i of `a` and j of `b` that meet, with j's low x not before i's (`strictly`: after).
template <class F>
void sweep(const std::vector<SweptBox>& a, const std::vector<SweptBox>& b, bool strictly, const F& f) {
  const auto order_a = by_low_x(a), order_b = by_low_x(b);
  std::size_t first = 0;
  for (const auto i : order_a) {
    const auto is_before = [&](std::uint32_t j) {
      return strictly ? b[j].low[0] <= a[i].low[0] : b[j].low[0] < a[i].low[0];
    };
    while (first < order_b.size() && is_before(order_b[first])) ++first;
    for (std::size_t k = first; k < order_b.size() && b[order_b[k]].low[0] <= a[i].high[0]; ++k)
      if (meet(a[i], b[order_b[k]])) f(i, order_b[k]);
  }
}

}  // namespace

std::uint64_t hash_of(const Pair& pair) {
  std::uint64_t hash = static_cast<std::uint64_t>(pair.kind) + 1;
  for (const Index vertex : pair.vertices) {
    hash = (hash + static_cast<std::uint64_t>(vertex)) * 0x9e3779b97f4a7c15;
    hash ^= hash >> 29;
  }
  return hash;
}

void SweptBoxes::compute(const Task& task) {
  const Mesh& mesh = task.mesh;
  points.resize(mesh.points().size());
  edges.resize(mesh.edges().size());
  faces.resize(mesh.faces().size());
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = box_of(task, mesh.points().subspan(i, 1));
  for (std::size_t i = 0; i < edges.size(); ++i) edges[i] = box_of(task, mesh.edges()[i]);
  for (std::size_t i = 0; i < faces.size(); ++i) faces[i] = box_of(task, mesh.faces()[i]);
}

void PairCounter::add_vf(std::size_t point, std::size_t face, Batch& batch) const {
  const Index p = mesh_.points()[point];
  const Face& f = mesh_.faces()[face];
  if (f[0] == p || f[1] == p || f[2] == p) return;
  ++batch.count;
  batch.sum += hash_of({PairKind::vertex_face, {p, f[0], f[1], f[2]}});
}

void PairCounter::add_ee(std::size_t a, std::size_t b, Batch& batch) const {
  if (a > b) std::swap(a, b);
  const Edge &e = mesh_.edges()[a], &f = mesh_.edges()[b];
  if (e[0] == f[0] || e[0] == f[1] || e[1] == f[0] || e[1] == f[1]) return;
  ++batch.count;
  batch.sum += hash_of({PairKind::edge_edge, {e[0], e[1], f[0], f[1]}});
}

void PairCounter::commit(PairKind kind, const Batch& batch) {
  (kind == PairKind::vertex_face ? vf_ : ee_).fetch_add(batch.count, std::memory_order_relaxed);
  sum_.fetch_add(batch.sum, std::memory_order_relaxed);
}

Answer PairCounter::answer(const Task& task) const {
  std::uint64_t expected = 0;
  for (const Pair& pair : task.candidates) expected += hash_of(pair);
  Answer answer{vf_, ee_, 0, 0, ""};
  const std::uint64_t count = vf_ + ee_, wanted = task.candidates.size();
  answer.missed = count < wanted ? wanted - count : 0;
  answer.extra = count > wanted ? count - wanted : 0;
  answer.note = sum_ == expected ? "the same pairs as by sort and sweep" : "OTHER pairs than by sort and sweep";
  return answer;
}

void find_candidates(Task& task) {
  SweptBoxes boxes;
  boxes.compute(task);
  const auto faces = task.mesh.faces();
  const auto edges = task.mesh.edges();
  const auto add_vf = [&](std::size_t point, std::size_t face) {
    const Index p = task.mesh.points()[point];
    const Face& f = faces[face];
    if (f[0] == p || f[1] == p || f[2] == p) return;
    task.candidates.push_back({PairKind::vertex_face, {p, f[0], f[1], f[2]}});
    task.vertex_face_candidates.push_back({p, static_cast<Index>(face)});
  };
  sweep(boxes.points, boxes.faces, false, add_vf);
  sweep(boxes.faces, boxes.points, true, [&](auto face, auto point) { add_vf(point, face); });
  // Two edges whose boxes begin at the same x come in both orders: keeps the ascending one.
  sweep(boxes.edges, boxes.edges, false, [&](std::size_t a, std::size_t b) {
    if (a == b || (boxes.edges[a].low[0] >= boxes.edges[b].low[0] && a > b)) return;
    const Edge &e = edges[std::min(a, b)], &f = edges[std::max(a, b)];
    if (e[0] != f[0] && e[0] != f[1] && e[1] != f[0] && e[1] != f[1])
      task.candidates.push_back({PairKind::edge_edge, {e[0], e[1], f[0], f[1]}});
  });
}

}  // namespace tamis::bench
