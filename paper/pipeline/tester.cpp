#include "paper/pipeline/tester.hpp"

#include <numeric>

#include "pair/narrow/decide.hpp"
#include "pair/narrow/sharp_bracket.hpp"
#include "paper/pipeline/interval_newton.hpp"
#include "search/query/cancellation.hpp"
#include "search/query/stage_counts.hpp"
#include "search/query/stopwatch.hpp"
#include "search/query/what_counts.hpp"
#include "search/topology/at.hpp"
#include "support/yardstick/pairs.hpp"

namespace tamis::lab {
namespace {

using yardstick::are_adjacent, yardstick::in_contact_order, yardstick::lets_pass;

constexpr bool is_vf(PairKind kind) { return kind == PairKind::vertex_face; }

PairResult certified_contact(const ElementaryTest<double>& test) {
  const double length = std::sqrt(dot(test.normal, test.normal));
  const Vec3<double> n = (1 / length) * test.normal;
  return {true, Certainty::certified, test.lower, test.upper, test.u, test.v, {n.x, n.y, n.z}};
}

}  // namespace

PaperCounts::PaperCounts(std::span<const FilterStage> stages) {
  for (const FilterStage& stage : stages) filters.push_back({stage.name});
}

void PaperCounts::add(const PaperCounts& other) {
  tamis::add(boxes, other.boxes);
  tamis::add(newton, other.newton);
  tamis::add(decide, other.decide);
  for (std::size_t i = 0; i < filters.size(); ++i) tamis::add(filters[i], other.filters[i]);
  decided_by += other.decided_by;
  filter_seconds += other.filter_seconds;
  solve_seconds += other.solve_seconds;
  bounds_tested += other.bounds_tested;
  triangle_pairs += other.triangle_pairs;
}

PaperTester::PaperTester(const PaperScene& scene) : counts(scene.stages), scene_(scene) { begin(); }

void PaperTester::add_triangles(Index a, Index b) {
  const TriangleFeatures &s = scene_.triangles[at(a)], &t = scene_.triangles[at(b)];
  if (scene_.paper.orphan_sets && share_a_vertex(s.vertices, t.vertices)) return;
  ++counts.triangle_pairs;
  if (a >= scene_.face_count && b >= scene_.face_count) add_loose(a, b);
  const bool own = scene_.paper.representative_triangles;
  const unsigned s_vertices = own ? s.own_vertices : s.all_vertices, s_edges = own ? s.own_edges : s.all_edges;
  const unsigned t_vertices = own ? t.own_vertices : t.all_vertices, t_edges = own ? t.own_edges : t.all_edges;
  for (unsigned i = 0; i < 3; ++i) {
    if ((s_vertices >> i & 1) && b < scene_.face_count) add_vertex_face(s.vertices[i], b);
    if ((t_vertices >> i & 1) && a < scene_.face_count) add_vertex_face(t.vertices[i], a);
    if (!(s_edges >> i & 1)) continue;
    for (unsigned j = 0; j < 3; ++j)
      if (t_edges >> j & 1) add_edges(s.edges[i], t.edges[j]);
  }
}

void PaperTester::add_loose(Index a, Index b) {
  const Face &s = scene_.triangles[at(a)].vertices, &t = scene_.triangles[at(b)].vertices;
  const bool s_is_point = s[0] == s[1], t_is_point = t[0] == t[1];
  if (!s_is_point && !t_is_point) return;  // two edges
  const PairKind kind = s_is_point && t_is_point ? PairKind::vertex_vertex : PairKind::vertex_edge;
  const Face &point = s_is_point ? s : t, &other = s_is_point ? t : s;
  const PairVertices v =
      in_contact_order(kind, {point[0], other[0], kind == PairKind::vertex_edge ? other[1] : -1, -1});
  if (!lets_pass(scene_.options.filter, kind, v) || !found.wants(kind, v)) return;
  ++of(counts.decide, kind);
  const auto r =
      decide({kind, points_of(found.query().step, v), found.query().separations.between(kind, v)}, counts.decided_by);
  if (!add_what_counts(found, kind, v, r, counts.decided_by)) return;
  if (found.query().question == Question::all_contacts) features.push_back({a, b});
}

void PaperTester::add_vertex_face(Index vertex, Index face) {
  if (!overlap(scene_.boxes.vertices[at(vertex)], scene_.boxes.faces[at(face)])) return;
  const Face& f = scene_.triangles[at(face)].vertices;
  add(vf_, {vertex, face}, {vertex, f[0], f[1], f[2]});
}

void PaperTester::add_edges(Index edge0, Index edge1) {
  if (!overlap(scene_.boxes.edges[at(edge0)], scene_.boxes.edges[at(edge1)])) return;
  if (edge1 < edge0) std::swap(edge0, edge1);  // edges are sorted: the smaller index is the smaller edge
  const Edge &a = scene_.mesh.edges()[at(edge0)], &b = scene_.mesh.edges()[at(edge1)];
  add(ee_, {edge0, edge1}, {a[0], a[1], b[0], b[1]});
}

void PaperTester::flush() {
  test(vf_);
  test(ee_);
}

void PaperTester::begin() {
  found.begin(scene_.answer->query(), scene_.answer->bound());
  vf_.size = ee_.size = 0;  // an exception may have left pairs of another question
  features.clear();
  counts = PaperCounts(scene_.stages);
}

std::uint64_t PaperTester::memory_bytes() const {
  return sizeof(*this) + found.memory_bytes() + features.capacity() * sizeof(features[0]);
}

template <PairKind kind>
void PaperTester::add(Block<kind>& block, const std::array<Index, 2>& pair, const PairVertices& v) {
  const tamis::Options& options = scene_.options;
  if (!scene_.paper.orphan_sets && are_adjacent(kind, v)) return;
  if (!lets_pass(options.filter, kind, v)) return;
  const MovingPoints& p = scene_.points;
  block.features[block.size] = pair;
  block.vertices[block.size] = v;
  block.motions[block.size] = relative_motion<kind>(p[v[0]], p[v[1]], p[v[2]], p[v[3]]);
  if (++block.size == kBlock) test(block);
}

template <PairKind kind>
void PaperTester::test(Block<kind>& block) {
  if (block.size == 0) return;
  stop_if_cancelled(scene_.options);
  std::array<std::uint16_t, kBlock> pairs;
  std::iota(pairs.begin(), pairs.end(), std::uint16_t{0});
  std::span alive = std::span(pairs).first(block.size);
  of(counts.boxes, kind) += alive.size();
  Stopwatch watch;
  // A filter proves that features do not touch, not that they keep a distance.
  if (!scene_.answer->query().separations.any()) alive = alive.first(run_filters(block, alive));
  counts.filter_seconds += watch.lap();
  for (const std::uint16_t pair : alive) solve(block, pair);
  counts.solve_seconds += watch.lap();
  block.size = 0;
}

template <PairKind kind>
std::size_t PaperTester::run_filters(const Block<kind>& block, std::span<std::uint16_t> alive) {
  for (std::size_t i = 0; i < scene_.stages.size(); ++i) {
    of(counts.filters[i], kind) += alive.size();
    const auto cull = is_vf(kind) ? scene_.stages[i].vf : scene_.stages[i].ee;
    alive = alive.first(cull(block.motions.data(), alive));
  }
  return alive.size();
}

template <PairKind kind>
void PaperTester::solve(const Block<kind>& block, std::size_t pair) {
  stop_if_cancelled(scene_.options);
  if (!found.wants(kind, block.vertices[pair])) return;
  const PairResult r = result_of(block, pair);
  if (!add_what_counts(found, kind, block.vertices[pair], r, counts.decided_by)) return;
  if (found.query().question == Question::all_contacts) features.push_back(block.features[pair]);
}

template <PairKind kind>
PairResult PaperTester::result_of(const Block<kind>& block, std::size_t pair) {
  if (!scene_.answer->query().separations.any()) {
    of(counts.newton, kind) += 1;
    const auto test = interval_newton_test<kind>(block.motions[pair]);
    if (test.verdict == Verdict::is_free || (test.verdict == Verdict::touches && is_sharp(test.lower, test.upper))) {
      ++counts.decided_by.scalar;
      return test.verdict == Verdict::touches ? certified_contact(test) : PairResult{};
    }
  }
  of(counts.decide, kind) += 1;
  const PairVertices& v = block.vertices[pair];
  return decide({kind, points_of(found.query().step, v), found.query().separations.between(kind, v)},
                counts.decided_by);
}

}  // namespace tamis::lab
