// Every pair of features, no hierarchy and no filter but the decision itself: slow and plain, for tests.
#include "detect/engine.hpp"
#include "detect/pair_rules.hpp"
#include "solve/decide.hpp"

namespace tamis {
namespace {

class BruteEngine final : public Engine {
 public:
  BruteEngine(const Mesh& mesh, const Options& options) : mesh_(mesh), options_(options) {}

  void find(const Step& step, Question, std::vector<Contact>& contacts, Statistics& statistics) override {
    StageCount count{"solve"};
    const auto test = [&](PairKind kind, PairVertices v) {
      v = in_contact_order(kind, v);
      if (are_adjacent(kind, v) || !lets_pass(options_.filter, kind, v)) return;
      ++(kind == PairKind::vertex_face ? count.vf : count.ee);
      const auto r =
          decide(kind, points_of(step, v), {options_.guarantee, options_.min_separation}, statistics.decided_by);
      if (r.touches) contacts.push_back({kind, r.certainty, v, r.toi_lower, r.toi_upper, r.u, r.v, r.normal});
    };
    for (Index p : mesh_.points())
      for (const Face& f : mesh_.faces()) test(PairKind::vertex_face, {p, f[0], f[1], f[2]});
    const auto edges = mesh_.edges();
    for (std::size_t j = 0; j < edges.size(); ++j)
      for (std::size_t i = 0; i < j; ++i)
        test(PairKind::edge_edge, {edges[i][0], edges[i][1], edges[j][0], edges[j][1]});
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
