// Questions about a mesh at rest.
#pragma once
#include <cstdint>
#include <tuple>
#include <vector>

#include "motion/separations.hpp"
#include "tamis/near.hpp"
#include "tamis/statistics.hpp"
#include "tamis/step.hpp"

namespace tamis {

enum class Intersections : std::uint8_t { all, any };

inline bool comes_first(const Intersection& a, const Intersection& b) {
  return std::tie(a.edge, a.face) < std::tie(b.edge, b.face);
}

class RestEngine {
 public:
  virtual ~RestEngine() = default;

  /// Every pair within its separation, by kind, then vertices. Adds stages, seconds (but `total`), counts and `rebuilt`
  /// to `statistics`. REQUIRES: positions of the mesh's vertices. REQUIRES (not checked: O(n)): validated positions.
  /// Runs in the caller's oneTBB arena.
  virtual void find_near(const Positions& positions, const Separations& separations, std::vector<NearPair>& pairs,
                         Statistics& statistics) = 0;

  /// By edge, then the face's vertices; `any`: at most one. Decided exactly, otherwise as find_near.
  virtual void find_intersections(const Positions& positions, Intersections wanted, std::vector<Intersection>& found,
                                  Statistics& statistics) = 0;
};

}  // namespace tamis
