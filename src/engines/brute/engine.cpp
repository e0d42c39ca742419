// Every pair of features, no hierarchy and no filter but the decision itself: slow and plain, for tests.
#include "engines/engine.hpp"

#include "engines/cancellation.hpp"
#include "engines/pair_rules.hpp"
#include "solve/decide.hpp"

namespace tamis {
namespace {

class BruteEngine final : public Engine {
 public:
  BruteEngine(const Mesh& mesh, const Options& options) : mesh_(mesh), options_(options) {}

  void find(FoundContacts& found, Statistics& statistics) override {
    StageCount count{"solve"};
    for_each_pair(mesh_, options_.filter, [&](PairKind kind, const PairVertices& v) {
      stop_if_cancelled(options_);
      if (!found.wants(kind, v)) return;
      ++(kind == PairKind::vertex_face ? count.vf : count.ee);
      const auto r = decide(kind, points_of(found.step(), v), found.rule_for(kind, v), statistics.decided_by);
      if (r.touches) found.add({kind, r.certainty, v, r.toi_lower, r.toi_upper, r.u, r.v, r.normal});
    });
    statistics.stages.push_back(count);
  }

  std::uint64_t memory_bytes() const override { return 0; }

 private:
  const Mesh& mesh_;
  const Options& options_;
};

}  // namespace

std::unique_ptr<Engine> make_brute_engine(const Mesh& mesh, const Options& options) {
  return std::make_unique<BruteEngine>(mesh, options);
}

}  // namespace tamis
