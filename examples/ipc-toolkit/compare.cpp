// compare [START.ply END.ply]: one step through ipc-toolkit, with its own phases and with Tamis in their place. Fails
// unless the steps are free by Tamis, and the candidates of Tamis are those of ipc-toolkit that touch. Without files: a
// sheet that falls onto another one.
#include <igl/edges.h>
#include <tbb/global_control.h>

#include <chrono>
#include <cstdio>
#include <functional>
#include <ipc/broad_phase/lbvh.hpp>
#include <ipc/candidates/candidates.hpp>
#include <ipc/ccd/additive_ccd.hpp>
#include <ipc/ccd/tight_inclusion_ccd.hpp>
#include <ipc/ipc.hpp>
#include <set>
#include <tamis/from_matrix.hpp>
#include <tamis/pair.hpp>

#include "scene.hpp"
#include "tamis_broad_phase.hpp"
#include "tamis_ccd.hpp"

namespace {

double seconds(const std::function<void()>& work) {
  const auto before = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
}

/// The pairs of all candidates, as a list for Tamis.
std::vector<tamis::FeaturePair> pairs_of(const ipc::Candidates& candidates, const Scene& scene) {
  std::vector<tamis::FeaturePair> pairs;
  for (const auto& each : candidates.ee_candidates)
    pairs.push_back({tamis::PairKind::edge_edge, each.vertex_ids(scene.edges, scene.faces)});
  for (const auto& each : candidates.fv_candidates)
    pairs.push_back({tamis::PairKind::vertex_face, each.vertex_ids(scene.edges, scene.faces)});
  return pairs;
}

std::set<std::array<int, 4>> sorted(const ipc::Candidates& candidates) {
  std::set<std::array<int, 4>> rows;
  for (const auto& each : candidates.ee_candidates)
    rows.insert({0, int(std::min(each.edge0_id, each.edge1_id)), int(std::max(each.edge0_id, each.edge1_id)), 0});
  for (const auto& each : candidates.fv_candidates) rows.insert({1, int(each.face_id), int(each.vertex_id), 0});
  return rows;
}

ipc::Candidates candidates_by(ipc::BroadPhase& broad, const ipc::CollisionMesh& mesh, const Scene& scene) {
  ipc::Candidates candidates;
  candidates.build(mesh, scene.start, scene.end, 0, &broad);
  return candidates;
}

/// Of ipc-toolkit's candidates exactly those that touch are the candidates of Tamis.
void check_candidates(const ipc::Candidates& all, const ipc::Candidates& touching, const Scene& scene) {
  const auto start = tamis::points_of(scene.start), end = tamis::points_of(scene.end);
  const auto pairs = pairs_of(all, scene);
  const auto results = tamis::narrow_phase(pairs, {start, end});
  const auto expected = sorted(all), found = sorted(touching);
  std::size_t touch = 0;
  for (const auto& result : results) touch += result.touches;
  for (const auto& row : found)
    if (!expected.count(row)) fail("Tamis has a candidate that ipc-toolkit's broad phase lacks");
  if (touch != found.size())
    fail("ipc-toolkit has " + std::to_string(touch) + " pairs that touch, Tamis " + std::to_string(found.size()));
}

/// Both find the same about the step's ends.
void check_intersections(const ipc::CollisionMesh& mesh, const Scene& scene, ipc::BroadPhase& own,
                         ipc::TamisBroadPhase& tamis_broad) {
  for (const auto& [name, pose] : {std::pair("start", scene.start), std::pair("end", scene.end)}) {
    bool expected = false, found = false;
    const double by_own = seconds([&] { expected = ipc::has_intersections(mesh, pose, &own); });
    const double by_tamis = seconds([&] { found = ipc::has_intersections(mesh, pose, &tamis_broad); });
    if (expected != found) fail(std::string("has_intersections of the ") + name + " depends on the broad phase");
    std::printf("has_intersections, %-5s: %s, in %.2f ms by LBVH, %.2f ms by Tamis\n", name, found ? "yes" : "no",
                1e3 * by_own, 1e3 * by_tamis);
  }
}

/// A list's gain over one call a pair: the same answers, bit for bit.
void compare_batch(const ipc::Candidates& candidates, const Scene& scene) {
  const auto start = tamis::points_of(scene.start), end = tamis::points_of(scene.end);
  const auto pairs = pairs_of(candidates, scene);
  std::vector<tamis::PairResult> one(pairs.size()), list;
  const auto row = [](const auto& points, const auto& v) {
    return std::array<tamis::Point, 4>{points[std::size_t(v[0])], points[std::size_t(v[1])], points[std::size_t(v[2])],
                                       points[std::size_t(v[3])]};
  };
  const double by_pair = seconds([&] {
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const auto before = row(start, pairs[i].vertices), after = row(end, pairs[i].vertices);
      const bool edges = pairs[i].kind == tamis::PairKind::edge_edge;
      one[i] = edges ? tamis::edge_edge(before, after) : tamis::vertex_face(before, after);
    }
  });
  const double by_list = seconds([&] { list = tamis::narrow_phase(pairs, {start, end}); });
  for (std::size_t i = 0; i < pairs.size(); ++i)
    if (one[i].touches != list[i].touches || one[i].toi_lower != list[i].toi_lower)
      fail("a list has another answer than its pairs");
  std::printf("%zu candidates, each decided: %.2f ms by a call for each, %.2f ms by one call for the list\n",
              pairs.size(), 1e3 * by_pair, 1e3 * by_list);
}

}  // namespace

int main(int count, char** names) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  Scene scene = count == 3 ? step_between(names[1], names[2]) : sheets(40);
  igl::edges(scene.faces, scene.edges);
  const ipc::CollisionMesh mesh(scene.start, scene.edges, scene.faces);

  ipc::LBVH lbvh;
  ipc::TamisBroadPhase tamis_broad;
  const ipc::AdditiveCCD additive;
  const ipc::TightInclusionCCD tight;
  const ipc::TamisCCD tamis_ccd;
  struct Row {
    const char* name;
    ipc::BroadPhase* broad;
    const ipc::NarrowPhaseCCD* narrow;
  };
  const Row rows[] = {{"LBVH, AdditiveCCD", &lbvh, &additive},
                      {"LBVH, TightInclusionCCD", &lbvh, &tight},
                      {"LBVH, TamisCCD", &lbvh, &tamis_ccd},
                      {"TamisBroadPhase, TamisCCD", &tamis_broad, &tamis_ccd}};
  tamis::Detector judge(tamis::Mesh(static_cast<int>(scene.start.rows()), tamis::faces_of(scene.faces)));
  const auto start = tamis::points_of(scene.start);
  for (const auto& [name, broad, narrow] : rows) {
    ipc::Candidates candidates;
    double step = 1;
    // The second of two questions, as in a simulation, whose mesh stays.
    candidates_by(*broad, mesh, scene);
    const double found = seconds([&, broad_phase = broad] { candidates = candidates_by(*broad_phase, mesh, scene); });
    const double decided = seconds([&, narrow_phase = narrow] {
      step = candidates.compute_collision_free_stepsize(mesh, scene.start, scene.end, 0, *narrow_phase);
    });
    std::printf("%-26s step %.6f, %zu candidates in %.2f ms, decided in %.2f ms\n", name, step, candidates.size(),
                1e3 * found, 1e3 * decided);
    const auto end = tamis::points_of(Eigen::MatrixXd(scene.start + step * (scene.end - scene.start)));
    if (!judge.is_free({start, end})) fail(std::string(name) + " allows a step that is not free");
  }
  const auto all = candidates_by(lbvh, mesh, scene), touching = candidates_by(tamis_broad, mesh, scene);
  check_candidates(all, touching, scene);
  check_intersections(mesh, scene, lbvh, tamis_broad);
  compare_batch(all, scene);
}
