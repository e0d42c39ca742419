// The interface of the search of a mesh. A query goes in, its answer comes out.
#pragma once
#include <memory>
#include <tuple>
#include <vector>

#include "search/query/contact_collector.hpp"
#include "search/query/step_limit.hpp"
#include "tamis/proximity.hpp"

namespace tamis {

inline bool comes_first(const Intersection& a, const Intersection& b) {
  return std::tie(a.edge, a.face) < std::tie(b.edge, b.face);
}

/// One per detector; keeps its hierarchy and its buffers from question to question. Every question adds stages, seconds
/// (but `total`), counts and `rebuilt` to `statistics`, and runs in the caller's Arena. After an exception (from
/// the caller's filter, a cancellation, or lack of memory) the next question works. Neither threads nor instruction set
/// nor earlier questions change a bit of an answer. REQUIRES: positions of the mesh's vertices. REQUIRES (not checked:
/// O(n)): that they are validated.
class Engine {
 public:
  virtual ~Engine() = default;

  /// Adds the query's contacts to `answer`. For `all_contacts`: every contact, once. For `earliest`: at least every
  /// contact that may be the first. For `is_free`: at least one if there is any. A pair that `answer` does not want
  /// need not be decided. REQUIRES: answer.begin(query, ...).
  virtual void find(const Query& query, ContactCollector& answer, Statistics& statistics) = 0;

  /// The longest part of the step on which every pair keeps `fraction` of its distance. REQUIRES: 0 < fraction < 1.
  virtual SafeStep find_step_length(const Query& query, double fraction, Statistics& statistics) = 0;

  /// Every pair that is not proven to keep the fraction during the whole step, by kind, then vertices, with the time
  /// until which it is proven to. Pairs without a vertex of query.changed may be skipped. REQUIRES: 0 < fraction < 1.
  virtual void find_step_ends(const Query& query, double fraction, std::vector<StepLimit>& ends,
                              Statistics& statistics) = 0;

  /// Every pair within its separation in this pose, by kind, then vertices.
  virtual void find_near(const Query& query, std::vector<NearPair>& pairs, Statistics& statistics) = 0;

  /// Every edge that passes through a face in this pose, by edge, then the face's vertices. For `is_free` at least one,
  /// if there is any.
  virtual void find_intersections(const Query& query, std::vector<Intersection>& found, Statistics& statistics) = 0;

  /// Bytes held in the hierarchy and buffers.
  virtual std::uint64_t memory_bytes() const = 0;
};

/// The library's own. Keeps references: mesh and options must outlive it.
std::unique_ptr<Engine> make_tamis_engine(const Mesh& mesh, const Options& options);

}  // namespace tamis
