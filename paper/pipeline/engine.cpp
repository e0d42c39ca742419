// The published pipeline (Du, Tang, Tong 2012): a binary hierarchy of swept k-DOPs over triangles, refitted every step,
// finds triangle pairs without a common vertex, and orphan sets add the other pairs of features; then representative
// triangles, filters and interval Newton.
#include "paper/pipeline/engine.hpp"

#include <algorithm>
#include <tuple>

#include "numbers/in_parts.hpp"
#include "numbers/pool.hpp"
#include "paper/pipeline/hierarchy.hpp"
#include "paper/pipeline/patch_culling.hpp"
#include "paper/pipeline/tester.hpp"
#include "paper/topology/orphan_sets.hpp"
#include "paper/topology/surface.hpp"
#include "search/query/engine.hpp"
#include "search/query/stage_counts.hpp"
#include "search/query/stopwatch.hpp"

namespace tamis::lab {
namespace {

std::vector<FilterStage> stages_by_name(const std::vector<std::string>& names) {
  std::vector<FilterStage> stages;
  for (const std::string& name : names) stages.push_back(filter_stage_by_name(name));
  return stages;
}

/// The culling that is sound with these options. Without orphan sets, triangles with a common vertex are tested too,
/// and subspace certificates say nothing about them.
HighLevelCulling high_level_of(const PaperOptions& paper) {
  const bool needs_orphan_sets = paper.high_level == HighLevelCulling::subspace;
  const bool may_cull = paper.orphan_sets || !needs_orphan_sets;
  return may_cull ? paper.high_level : HighLevelCulling::none;
}

/// Finds contacts; leaves all other questions to the method `tamis`.
class PaperEngine final : public Engine {
 public:
  PaperEngine(const Mesh& mesh, const tamis::Options& options, const PaperOptions& paper, TriangleCounts* counts)
      : asked_mesh_(mesh),
        asked_options_(options),
        paper_(paper),
        counts_(counts),
        surface_(mesh),
        scene_{options, paper_, surface_.mesh(), surface_.face_count(), {}, stages_by_name(paper.filters), {}, {}},
        hierarchy_(make_paper_hierarchy(paper.bounding_volume)),
        patches_(scene_.mesh, high_level_of(paper), paper_.reduced_model.get()),
        testers_([this](std::size_t) { return std::make_unique<PaperTester>(scene_); }) {}

  void find(const Query& query, ContactCollector& answer, Statistics& statistics) override {
    scene_.answer = &answer;
    update_bounds(statistics);
    const Stopwatch watch;
    for (const auto& tester : testers_.all()) tester->begin();
    std::visit([&](const auto& hierarchy) { visit_all(hierarchy.traversal(free_within()), query.question); },
               hierarchy_);
    collect(answer, statistics, watch.seconds());
  }
  SafeStep find_step_length(const Query& query, double fraction, Statistics& statistics) override {
    return others().find_step_length(query, fraction, statistics);
  }
  void find_step_ends(const Query& query, double fraction, std::vector<StepLimit>& ends,
                      Statistics& statistics) override {
    others().find_step_ends(query, fraction, ends, statistics);
  }
  void find_near(const Query& query, std::vector<NearPair>& pairs, Statistics& statistics) override {
    others().find_near(query, pairs, statistics);
  }
  void find_intersections(const Query& query, std::vector<Intersection>& found, Statistics& statistics) override {
    others().find_intersections(query, found, statistics);
  }
  std::uint64_t memory_bytes() const override {
    std::uint64_t bytes = held_bytes(others_) + patches_.memory_bytes() + scene_.points.memory_bytes() +
                          scene_.boxes.memory_bytes() + scene_.triangles.capacity() * sizeof(TriangleFeatures) +
                          std::visit([](const auto& h) { return h.memory_bytes(); }, hierarchy_);
    for (const auto* pairs : {&orphans_.vf, &orphans_.ee}) bytes += pairs->capacity() * sizeof((*pairs)[0]);
    return bytes + testers_.memory_bytes();
  }

 private:
  Engine& others() {
    if (!others_) others_ = make_tamis_engine(asked_mesh_, asked_options_);
    return *others_;
  }

  void update_bounds(Statistics& statistics) {
    Stopwatch watch;
    if (scene_.triangles.empty()) collect_topology();
    scene_.points.update(scene_.mesh, scene_.answer->query().step);
    // Each of two features is padded by half of the fixed separation and by the largest radius; the factor covers the
    // rounding of `padding`. Scales before it halves: half of the smallest double is zero.
    const Separations& separations = scene_.answer->query().separations;
    const double scale = scene_.points.scale();
    const double padding = (0.5 * (separations.fixed * scale) + separations.largest_radius() * scale) * (1 + 0x1p-50);
    scene_.boxes.update(scene_.mesh, scene_.points, padding);
    statistics.seconds.bounds += watch.lap();
    statistics.rebuilt |= std::visit(
        [&](auto& hierarchy) {
          return hierarchy.update(scene_.mesh.faces(), scene_.points, padding, patches_.order());
        },
        hierarchy_);
    if (!separations.any())
      std::visit(
          [&](auto& hierarchy) { patches_.update(hierarchy.tree(), scene_.points, scene_.answer->query().step); },
          hierarchy_);
    statistics.seconds.build += watch.lap();
  }

  /// Empty with a separation: the proofs are that a patch does not touch itself, not that it keeps a distance.
  std::span<const std::uint8_t> free_within() const {
    if (scene_.answer->query().separations.any()) return {};
    return patches_.free_within();
  }

  void collect_topology() {
    scene_.triangles = choose_representatives(scene_.mesh);
    if (!paper_.orphan_sets) return;
    OrphanSets sets = collect_orphan_sets(scene_.mesh, scene_.face_count);
    orphans_ = std::move(sets.orphans);
    if (!paper_.representative_triangles) return;
    orphans_.vf.insert(orphans_.vf.end(), sets.displaced.vf.begin(), sets.displaced.vf.end());
    orphans_.ee.insert(orphans_.ee.end(), sets.displaced.ee.begin(), sets.displaced.ee.end());
  }

  /// Visits the hierarchy's pairs of triangles in parts, and the orphans in chunks. Unless all contacts are asked for,
  /// the blocks are tested after each part or chunk.
  template <class Traversal>
  void visit_all(const Traversal& traversal, Question question) {
    const auto run = [&](const auto& work) {
      const auto taken = testers_.take();
      PaperTester& tester = *taken;
      if (!tester.found.wants(PairKind::vertex_face) && !tester.found.wants(PairKind::edge_edge)) return;
      work(tester);
      if (question != Question::all_contacts) tester.flush();
    };
    const auto parts = traversal.parts(kParts);
    const auto visit = [&](const SubtreePair& part) {
      run([&](PaperTester& tester) {
        traversal.visit(
            part, [&](Index a, Index b) { tester.add_triangles(a, b); }, tester.counts.bounds_tested);
      });
    };
    for_each_in_parts(parts, 1, visit);
    const auto in_chunks = [&](const auto& pairs, auto add) {
      in_parts(pairs.size(), kChunk, [&](std::size_t begin, std::size_t end) {
        run([&](PaperTester& tester) {
          for (std::size_t i = begin; i < end; ++i) add(tester, pairs[i]);
        });
      });
    };
    in_chunks(orphans_.vf, [](PaperTester& tester, const auto& pair) { tester.add_vertex_face(pair[0], pair[1]); });
    in_chunks(orphans_.ee, [](PaperTester& tester, const auto& pair) { tester.add_edges(pair[0], pair[1]); });
    for_each_in_parts(testers_.all(), 1, [](const std::unique_ptr<PaperTester>& tester) { tester->flush(); });
  }

  void collect(ContactCollector& answer, Statistics& statistics, double seconds) {
    PaperCounts sum(scene_.stages);
    for (const auto& tester : testers_.all()) {
      sum.add(tester->counts);
      answer.take(tester->found);
    }
    if (answer.query().question == Question::all_contacts && !paper_.representative_triangles)
      drop_duplicates(answer.contacts());
    tamis::add(statistics.stages, sum.boxes);
    for (const StageCount& filter : sum.filters) tamis::add(statistics.stages, filter);
    tamis::add(statistics.stages, sum.newton);
    tamis::add(statistics.stages, sum.decide);
    statistics.decided_by += sum.decided_by;
    statistics.nodes_visited += sum.bounds_tested;
    if (counts_) *counts_ = {sum.triangle_pairs, free_within().empty() ? 0 : patches_.triangles_in_free_patches()};
    share_out(sum, seconds, statistics);
  }

  /// Splits the seconds of the one pass among filters, solver and traversal, by the means over the threads.
  static void share_out(const PaperCounts& sum, double seconds, Statistics& statistics) {
    const double threads = std::max(1.0, double(statistics.threads));
    const double filter = sum.filter_seconds / threads, solve = sum.solve_seconds / threads;
    statistics.seconds.filter += filter;
    statistics.seconds.solve += solve;
    statistics.seconds.traverse += std::max(0.0, seconds - filter - solve);
  }

  /// Without representative triangles a pair is found several times: keeps one contact for each pair of features.
  void drop_duplicates(std::vector<Contact>& contacts) const {
    using Key = std::tuple<PairKind, std::array<Index, 2>>;
    std::vector<std::pair<Key, Contact>> keyed;
    std::size_t i = 0;
    for (const auto& tester : testers_.all())
      for (const auto& features : tester->features) {
        keyed.push_back({{contacts[i].kind, features}, contacts[i]});
        ++i;
      }
    const auto key = [](const auto& entry) { return entry.first; };
    std::ranges::sort(keyed, {}, key);
    const auto same = [&](const auto& a, const auto& b) { return key(a) == key(b); };
    keyed.erase(std::unique(keyed.begin(), keyed.end(), same), keyed.end());
    contacts.clear();
    for (const auto& entry : keyed) contacts.push_back(entry.second);
  }

  static constexpr std::size_t kParts = 1024;  ///< enough for any number of threads to share evenly
  static constexpr std::size_t kChunk = 4096;

  const Mesh& asked_mesh_;
  const tamis::Options& asked_options_;
  std::unique_ptr<Engine> others_;  ///< made by the first question that needs it
  const PaperOptions paper_;
  TriangleCounts* const counts_;
  Surface surface_;
  PaperScene scene_;
  FeaturePairs orphans_;
  AnyPaperHierarchy hierarchy_;
  PatchCulling patches_;
  Pool<PaperTester> testers_;
};

}  // namespace

std::unique_ptr<Engine> make_paper_engine(const Mesh& mesh, const tamis::Options& options, const PaperOptions& paper,
                                          TriangleCounts* counts) {
  return std::make_unique<PaperEngine>(mesh, options, paper, counts);
}

}  // namespace tamis::lab
