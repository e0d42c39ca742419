// Every pair of features, no hierarchy and no filter but the decision itself: slow and plain, for tests.
#include "lab/brute.hpp"

#include <algorithm>

#include "engines/cancellation.hpp"
#include "engines/near_order.hpp"
#include "engines/stage_counts.hpp"
#include "lab/pairs.hpp"
#include "narrow/decide.hpp"
#include "narrow/near_pair.hpp"

namespace tamis::lab {
namespace {

class BruteEngine final : public Engine {
 public:
  BruteEngine(const Mesh& mesh, const tamis::Options& options) : mesh_(mesh), options_(options) {}

  void find(FoundContacts& found, Statistics& statistics) override {
    StageCount count{"solve"};
    for_each_pair(mesh_, options_.filter, [&](PairKind kind, const PairVertices& v) {
      stop_if_cancelled(options_);
      if (!found.wants(kind, v)) return;
      ++of(count, kind);
      const auto r = decide(kind, points_of(found.step(), v), found.rule_for(kind, v), statistics.decided_by);
      if (r.touches) found.add({kind, r.certainty, v, r.toi_lower, r.toi_upper, r.u, r.v, r.normal});
    });
    statistics.stages.push_back(count);
  }

  SafeStep find_step_length(const Step& step, const Separations& separations, double fraction,
                            Statistics& statistics) override {
    StepLimit limit;
    for_each_limit(step, {fraction, separations}, statistics, [&](const StepLimit& pair) { limit.add(pair); });
    return limit.answer(step, fraction, separations);
  }

  void find_step_ends(const Step& step, const Separations& separations, double fraction, std::vector<StepLimit>& ends,
                      Statistics& statistics) override {
    ends.clear();
    for_each_limit(step, {fraction, separations}, statistics, [&](const StepLimit& pair) {
      if (pair.time < 1) ends.push_back(pair);
    });
    std::sort(ends.begin(), ends.end(), comes_before_in_order);
  }

  void find_near(const Positions& positions, const Separations& separations, std::vector<NearPair>& pairs,
                 Statistics& statistics) override {
    const Step step{positions, positions};
    StageCount count{"near"};
    std::array<std::vector<PairVertices>, kPairKinds> found;
    for_each_pair(mesh_, options_.filter, [&](PairKind kind, const PairVertices& v) {
      stop_if_cancelled(options_);
      ++of(count, kind);
      if (is_near(kind, points_of(step, v), separations.between(kind, v), statistics.decided_by))
        found[static_cast<std::size_t>(kind)].push_back(v);
    });
    statistics.stages.push_back(count);
    pairs.clear();
    for (std::size_t kind = 0; kind < kPairKinds; ++kind) {
      NearOrder().sort(found[kind], mesh_.vertex_count());
      for (const PairVertices& v : found[kind]) {
        stop_if_cancelled(options_);
        pairs.push_back(near_pair(static_cast<PairKind>(kind), v, points_of(step, v)));
      }
    }
  }

  void find_intersections(const Positions& positions, Intersections wanted, std::vector<Intersection>& found,
                          Statistics& statistics) override {
    StageCount count{"solve"};
    found.clear();
    for (const Edge& edge : mesh_.edges())
      for (const Face& face : mesh_.faces()) {
        stop_if_cancelled(options_);
        if (wanted == Intersections::any && !found.empty()) break;
        if (!is_pair(edge, face)) continue;
        ++count.vf;
        const auto r = decide(PairKind::vertex_face, points_along(positions, edge, face), {}, statistics.decided_by);
        if (r.touches) found.push_back({edge, face, r.toi_lower, r.toi_upper, r.u, r.v});
      }
    statistics.stages.push_back(count);
    std::sort(found.begin(), found.end(), comes_first);
  }

  std::uint64_t memory_bytes() const override { return 0; }

 private:
  struct KeptFraction {
    double fraction;
    const Separations& separations;
  };

  /// keep(StepLimit) for every pair.
  template <class Keep>
  void for_each_limit(const Step& step, const KeptFraction& kept, Statistics& statistics, const Keep& keep) const {
    StageCount count{"near"};
    for_each_pair(mesh_, options_.filter, [&](PairKind kind, const PairVertices& v) {
      stop_if_cancelled(options_);
      ++of(count, kind);
      const DistanceRule rule{kept.fraction, kept.separations.between(kind, v)};
      keep(StepLimit{keeps_distance_until(kind, points_of(step, v), rule, 1, statistics.decided_by), kind, v});
    });
    statistics.stages.push_back(count);
  }

  bool is_pair(const Edge& edge, const Face& face) const {
    const auto shares = [&](Index v) { return v == edge[0] || v == edge[1]; };
    if (std::any_of(face.begin(), face.end(), shares)) return false;
    return !has_groups(options_.filter) || may_touch(options_.filter, edge[0], face[0]);
  }

  const Mesh& mesh_;
  const tamis::Options& options_;
};

}  // namespace

std::unique_ptr<Engine> make_brute_engine(const Mesh& mesh, const tamis::Options& options) {
  return std::make_unique<BruteEngine>(mesh, options);
}

}  // namespace tamis::lab
