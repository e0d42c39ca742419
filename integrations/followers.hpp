// Bodies that follow one that is held back are held back with it. Without this a pile would take a question for each of
// its bodies. No proof rests on it.
#pragma once
#include <array>
#include <map>
#include <set>
#include <vector>

#include "integrations/near_contacts.hpp"

namespace tamis::adapters {

/// In gaps: a pair that is known to be this near stays, too, if it touches before it has gone a gap. Otherwise its
/// distance would be halved in each step, until rounding to the engine's floats moves a body by more: by 2^-24 of its
/// distance from the origin, which at 800 units is this part of a gap of 1e-3. Farther from the origin bodies stay more
/// often; none passes through another.
inline constexpr double kLeastDistance = 0.05;
/// In steps: the precision that suffices for the time of a contact, and for the part of its way that a body may go.
inline constexpr double kTolerance = 1e-4;

/// The part of its way that each body of moving() goes.
using Fractions = std::map<BodyId, double>;

class Followers {
 public:
  /// Finds where bodies are near each other. Keeps a reference to the fractions.
  Followers(const Near& near, const WantedStep& step, double gap, Fractions& fractions);

  /// Shortens ways so that bodies keep apart where they are near, to first order. Returns the bodies whose fractions
  /// change.
  std::set<BodyId> hold_back();

 private:
  /// A place at which two bodies are near each other when a step begins.
  struct Approach {
    BodyPair bodies;
    double distance;                ///< > 0
    std::array<double, 2> closing;  ///< by how much each body's whole way reduces the distance; 0 for a body that stays
    std::array<double*, 2> fractions;  ///< null for a body that stays
  };

  bool hold_back_at(const Approach& approach, std::set<BodyId>& slower) const;

  const double gap_;
  std::vector<Approach> approaches_;
};

}  // namespace tamis::adapters
