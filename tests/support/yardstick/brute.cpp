// Decides every pair of features, without hierarchy or filters: slow and plain, for tests.
#include "support/yardstick/brute.hpp"

#include <algorithm>

#include "pair/narrow/decide.hpp"
#include "pair/narrow/near_pair.hpp"
#include "search/query/cancellation.hpp"
#include "search/query/pair_groups.hpp"
#include "search/query/pair_vertices.hpp"
#include "search/query/proximity_order.hpp"
#include "search/query/stage_counts.hpp"
#include "search/query/what_counts.hpp"
#include "support/yardstick/pairs.hpp"

namespace tamis::yardstick {
namespace {

class BruteEngine final : public Engine {
 public:
  explicit BruteEngine(const Mesh& mesh) : mesh_(mesh) {}

  void find(const Query& query, ContactCollector& answer, Statistics& statistics) override {
    StageCount count{"solve"};
    for_each_pair(mesh_, query.filter, [&](PairKind kind, const PairVertices& v) {
      stop_if_cancelled(query);
      if (!answer.wants(kind, v)) return;
      ++of(count, kind);
      const PairPoints points = points_of(query.step, v);
      const PairResult result = decide({kind, points, query.separations.between(kind, v)}, statistics.decided_by);
      add_what_counts(answer, kind, v, result, statistics.decided_by);
    });
    add(statistics.stages, count);
  }

  SafeStep find_step_length(const Query& query, double fraction, Statistics& statistics) override {
    StepLimit limit;
    for_each_limit(query, fraction, statistics, [&](const StepLimit& pair) { limit.add(pair); });
    return limit.answer(query, fraction);
  }

  void find_step_ends(const Query& query, double fraction, std::vector<StepLimit>& ends,
                      Statistics& statistics) override {
    ends.clear();
    for_each_limit(query, fraction, statistics, [&](const StepLimit& pair) { ends.push_back(pair); });
    std::sort(ends.begin(), ends.end(), comes_before_in_order);
  }

  void find_near(const Query& query, std::vector<NearPair>& pairs, Statistics& statistics) override {
    StageCount count{"near"};
    std::array<std::vector<PairVertices>, kPairKinds> found;
    for_each_pair(mesh_, query.filter, [&](PairKind kind, const PairVertices& v) {
      stop_if_cancelled(query);
      ++of(count, kind);
      if (may_start_within(kind, points_of(query.step, v), query.separations.between(kind, v), statistics.decided_by) &&
          !query.are_neighbours(kind, v))
        found[static_cast<std::size_t>(kind)].push_back(v);
    });
    add(statistics.stages, count);
    pairs.clear();
    for (std::size_t kind = 0; kind < kPairKinds; ++kind) {
      ProximityOrder().sort(found[kind], mesh_.vertex_count());
      for (const PairVertices& v : found[kind]) {
        stop_if_cancelled(query);
        pairs.push_back(near_pair(static_cast<PairKind>(kind), v, points_of(query.step, v)));
      }
    }
  }

  void find_intersections(const Query& query, std::vector<Intersection>& found, Statistics& statistics) override {
    StageCount count{"solve"};
    const Positions& positions = query.step.start;
    found.clear();
    for (const Edge& edge : mesh_.edges())
      for (const Face& face : mesh_.faces()) {
        stop_if_cancelled(query);
        if (query.question == Question::is_free && !found.empty()) break;
        if (!is_pair(query.filter, edge, face)) continue;
        ++count.vf;
        const auto r =
            decide({PairKind::vertex_face, edge_runner_points(positions, edge, face)}, statistics.decided_by);
        if (r.touches && !query.rings.are_neighbours(edge, face))
          found.push_back({edge, face, r.toi_lower, r.toi_upper, r.u, r.v});
      }
    add(statistics.stages, count);
    std::sort(found.begin(), found.end(), comes_first);
  }

  std::uint64_t memory_bytes() const override { return 0; }

 private:
  /// Calls keep(StepLimit) for every pair that ends the step.
  template <class Keep>
  void for_each_limit(const Query& query, double fraction, Statistics& statistics, const Keep& keep) const {
    StageCount count{"near"};
    for_each_pair(mesh_, query.filter, [&](PairKind kind, const PairVertices& v) {
      stop_if_cancelled(query);
      ++of(count, kind);
      const DistanceRule rule = query.distance_rule_for(kind, v, fraction);
      const double time = keeps_distance_until(kind, points_of(query.step, v), rule, 1, statistics.decided_by);
      if (time < 1 && !query.are_neighbours(kind, v)) keep(StepLimit{time, kind, v});
    });
    add(statistics.stages, count);
  }

  static bool is_pair(const PairFilter& filter, const Edge& edge, const Face& face) {
    const auto shares = [&](Index v) { return v == edge[0] || v == edge[1]; };
    if (std::any_of(face.begin(), face.end(), shares)) return false;
    return !has_groups(filter) || may_touch(filter, edge[0], face[0]);
  }

  const Mesh& mesh_;
};

}  // namespace

std::unique_ptr<Engine> make_brute_engine(const Mesh& mesh, const tamis::Options&) {
  return std::make_unique<BruteEngine>(mesh);
}

}  // namespace tamis::yardstick
