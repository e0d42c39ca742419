// For simulations of rigid bodies: how much of the step that an engine wants to make may be made, so that no two bodies
// pass through each other. No engine is known here; adapters/bullet shows what one has to bring.
#pragma once
#include <set>
#include <span>
#include <vector>

#include "tamis/world.hpp"

namespace tamis::adapters {

/// Two bodies, the smaller first.
using BodyPair = std::array<BodyId, 2>;
BodyPair pair_of(const std::array<BodyId, 2>& bodies);

/// A place at which two bodies are near each other when a step begins.
struct Approach {
  BodyPair bodies;
  double distance;                ///< > 0
  std::array<double, 2> closing;  ///< by how much the whole way of each body lessens it; of one that stays 0
};

/// A step that an engine wants to make. What is proven is the way of each body from pose(body, 0) to where it is put at
/// last: origin straight, turn by the shorter way about a fixed axis (`between`).
class WantedStep {
 public:
  virtual ~WantedStep() = default;

  /// Bodies that want to move and may be held back, each once. All others stay where World::move has put them.
  virtual std::span<const BodyId> moving() const = 0;
  /// Where a body is once it has gone `fraction` of its way, in [0, 1]: rounded as the engine will keep it, so that
  /// what is proven is what the engine does. At 0 where it is now; less than half a turn from there at 1.
  virtual Pose pose(BodyId body, double fraction) const = 0;
  /// Of a body of moving(), or of another: how far its points are from its origin, at most.
  virtual double radius(BodyId body) const = 0;
  /// Does the engine collide these two?
  virtual bool collides(const BodyPair& bodies) const = 0;
  /// Of two that it does: here, too? For bodies of several parts that differ in what they collide with. `vertices`: one
  /// of each body, of the feature there.
  virtual bool collides_at(const std::array<BodyId, 2>& /*bodies*/, const std::array<Index, 2>& /*vertices*/) const {
    return true;
  }
  /// Where bodies are known to be near each other, so that those that follow a body which is held back are held back
  /// with it: a pile would else take a question for each body in it. Any may be left out, and none need be exact: what
  /// is proven does not rest on them.
  virtual std::vector<Approach> approaches() const { return {}; }
};

struct ClampOptions {
  /// > 0, in the unit of the positions: how far from a contact a body is stopped. The engine must know that a contact
  /// is there when bodies are this near.
  double gap = 1e-3;
  /// >= 0: how often all are asked anew with shorter ways. After that bodies that still touch stay where they are. Each
  /// costs a question; more let bodies that run into each other one after the other go a little farther in this step.
  int rounds = 8;
};

/// Throws InvalidOptions where an option is out of its range.
void validate(const ClampOptions& options);

struct ClampedStep {
  /// One a body of moving(): which part of its way it may go, in [0, 1].
  std::vector<double> fractions;
  /// Questions that this took; 1 where nobody is held back.
  int questions = 0;
  /// What held bodies back: of each question and pair of bodies the first contact. Its times are of the ways asked
  /// then.
  std::vector<BodyContact> limits = std::vector<BodyContact>();
};

/// How a body that may move is told to stay: two bodies that are Static are never asked about, not even where they are.
BodyMotion resting(const Pose& pose);

/// Pairs of bodies whose surfaces pass through each other at t=0. Of two that are Static that is not looked for.
std::set<BodyPair> overlapping(World& world);
/// Those that the engine collides where they do.
std::set<BodyPair> overlapping(World& world, const WantedStep& step);

/// With these parts of their ways, no pair of bodies touches at any time, but those of `overlapping`, which the engine
/// has to part and which are not held back on account of each other, and features that touch already at t=0
/// (AtStart::ignore). A pair that touches later is held back, both bodies by the same part, to some `gap` before the
/// contact; a pair that is nearer than that may come half as near. Then all are asked anew, as bodies that move less
/// meet others elsewhere. Bodies far from any contact go all their way. Leaves `world` with the proven motions. Throws
/// InvalidOptions where an option is out of its range, and what World throws.
ClampedStep clamp(World& world, const WantedStep& step, const std::set<BodyPair>& overlapping,
                  const ClampOptions& options = {});

}  // namespace tamis::adapters
