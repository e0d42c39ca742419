// The library's engine: boxes that move in time, slab clip, DNF, NCF, certified roots. Pairs stream through in small
// buffers.
#include "search/query/engine.hpp"

#include "numbers/held_bytes.hpp"
#include "search/engine/contact_search.hpp"
#include "search/engine/intersection_search.hpp"
#include "search/engine/proximity_search.hpp"
#include "search/engine/step_length_search.hpp"

namespace tamis {
namespace {

class TamisEngine final : public Engine {
 public:
  TamisEngine(const Mesh& mesh, const Options& options) : workspace_(mesh, options) {}

  void find(const Query& query, ContactCollector& answer, Statistics& statistics) override {
    contacts_.find(query, answer, statistics);
  }
  SafeStep find_step_length(const Query& query, double fraction, Statistics& statistics) override {
    return step_lengths_.find(query, fraction, statistics);
  }
  void find_step_ends(const Query& query, double fraction, std::vector<StepLimit>& ends,
                      Statistics& statistics) override {
    step_lengths_.find_all(query, fraction, ends, statistics);
  }
  void find_near(const Query& query, std::vector<NearPair>& pairs, Statistics& statistics) override {
    proximity_.find(query, pairs, statistics);
  }
  void find_intersections(const Query& query, std::vector<Intersection>& found, Statistics& statistics) override {
    intersections_.find(query, found, statistics);
  }
  std::uint64_t memory_bytes() const override {
    return held_bytes(workspace_, contacts_, proximity_, intersections_, step_lengths_);
  }

 private:
  Workspace workspace_;
  ContactSearch contacts_{workspace_};
  ProximitySearch proximity_{workspace_};
  IntersectionSearch intersections_{workspace_};
  StepLengthSearch step_lengths_{workspace_};
};

}  // namespace

std::unique_ptr<Engine> make_tamis_engine(const Mesh& mesh, const Options& options) {
  return std::make_unique<TamisEngine>(mesh, options);
}

}  // namespace tamis
