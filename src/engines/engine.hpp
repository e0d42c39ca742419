// What searches a mesh: a question goes in, its answer comes out.
#pragma once
#include <memory>
#include <tuple>
#include <vector>

#include "engines/found_contacts.hpp"
#include "engines/step_limit.hpp"
#include "tamis/near.hpp"

namespace tamis {

enum class Intersections : std::uint8_t { all, any };

inline bool comes_first(const Intersection& a, const Intersection& b) {
  return std::tie(a.edge, a.face) < std::tie(b.edge, b.face);
}

/// One per detector; keeps its hierarchy and its buffers from question to question. Every question adds stages, seconds
/// (but `total`), counts and `rebuilt` to `statistics`, and runs in the caller's oneTBB arena. After an exception (of
/// the caller's filter, of a cancellation, or for want of memory) the engine can be asked again. Neither threads nor
/// instruction set nor earlier questions change a bit of an answer. REQUIRES: positions of the mesh's vertices.
/// REQUIRES (not checked: O(n)): that they are validated.
class Engine {
 public:
  virtual ~Engine() = default;

  /// Adds to `found` what its step and question ask for: for `all_contacts` every contact, once; for `earliest` at
  /// least every contact that may be the first; for `is_free` at least one if there is any. A pair that `found` does
  /// not want need not be decided.
  virtual void find(FoundContacts& found, Statistics& statistics) = 0;

  /// The longest part of the step on which every pair keeps `fraction` of its distance. REQUIRES: 0 < fraction < 1.
  virtual SafeStep find_step_length(const Step& step, const Separations& separations, double fraction,
                                    Statistics& statistics) = 0;

  /// Every pair that is not proven to keep the fraction during the whole step, by kind, then vertices, with the time
  /// until which it is. REQUIRES: 0 < fraction < 1.
  virtual void find_step_ends(const Step& step, const Separations& separations, double fraction,
                              std::vector<StepLimit>& ends, Statistics& statistics) = 0;

  /// Every pair within its separation in this pose, by kind, then vertices.
  virtual void find_near(const Positions& positions, const Separations& separations, std::vector<NearPair>& pairs,
                         Statistics& statistics) = 0;

  /// Every edge that passes through a face in this pose, by edge, then the face's vertices; `any`: at most one.
  virtual void find_intersections(const Positions& positions, Intersections wanted, std::vector<Intersection>& found,
                                  Statistics& statistics) = 0;

  /// Bytes held in the hierarchy and buffers.
  virtual std::uint64_t memory_bytes() const = 0;
};

/// The library's own. Keeps references: mesh and options must outlive it.
std::unique_ptr<Engine> make_tamis_engine(const Mesh& mesh, const Options& options);

}  // namespace tamis
