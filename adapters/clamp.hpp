// For engines of rigid bodies: how much of the step that an engine wants to make it may make, so that no two bodies
// pass through each other. This file knows no engine; adapters/bullet shows what an engine must provide.
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
  std::array<double, 2> closing;  ///< by how much each body's whole way reduces the distance; 0 for a body that stays
};

/// A step that an engine wants to make. The proof is about each body's way from pose(body, 0) to its final pose: the
/// origin goes straight, and the body turns the shorter way about a fixed axis (`between`).
class WantedStep {
 public:
  virtual ~WantedStep() = default;

  /// Bodies that are to move and may be held back, each once. All others stay where World::move has put them.
  virtual std::span<const BodyId> moving() const = 0;
  /// The pose of a body after `fraction` of its way, in [0, 1], rounded as the engine will keep it: so the proof is
  /// about what the engine does. At 0 the body is where it is now; at 1 it has turned by less than half a turn.
  virtual Pose pose(BodyId body, double fraction) const = 0;
  /// The largest distance of a body's points from its origin, or a bound of it; for all bodies.
  virtual double radius(BodyId body) const = 0;
  /// Does the engine collide these two bodies?
  virtual bool collides(const BodyPair& bodies) const = 0;
  /// Does the engine collide two bodies, for which `collides` is true, at these features? For bodies of several parts
  /// that collide with different things. `vertices`: for each body a vertex of its feature.
  virtual bool collides_at(const std::array<BodyId, 2>& /*bodies*/, const std::array<Index, 2>& /*vertices*/) const {
    return true;
  }
  /// Where bodies are known to be near each other. With these a body that follows one that is held back is held back
  /// with it; without them a pile takes a question for each of its bodies. Any approach may be left out, and none need
  /// be exact: no proof rests on them.
  virtual std::vector<Approach> approaches() const { return {}; }
};

struct ClampOptions {
  /// > 0, in the unit of the positions: how far before a contact a body is stopped. The engine must see a contact when
  /// bodies are this near.
  double gap = 1e-3;
  /// >= 0: how often the question is asked again with shorter ways. After these rounds bodies that still touch stay
  /// where they are. Each round costs a question. With more rounds, bodies that run into each other one after the other
  /// go a little farther in this step.
  int rounds = 8;
};

/// Throws InvalidOptions where an option is out of its range.
void validate(const ClampOptions& options);

struct ClampedStep {
  /// For each body of moving() the fraction of its way that it may go, in [0, 1].
  std::vector<double> fractions;
  /// How many questions were asked; 1 if no body is held back.
  int questions = 0;
  /// The contacts that held bodies back: for each question and pair of bodies the first one. Its times are fractions of
  /// the ways that this question was about.
  std::vector<BodyContact> limits = std::vector<BodyContact>();
};

/// The motion of a body that stays but may move later. With Static instead, questions would leave out two such bodies,
/// even at rest.
BodyMotion resting(const Pose& pose);

/// Pairs of bodies whose surfaces pass through each other at t=0; not of two Static bodies.
std::set<BodyPair> overlapping(World& world);
/// The same; only pairs that the engine collides where they pass through each other.
std::set<BodyPair> overlapping(World& world, const WantedStep& step);

/// Shortens the ways of bodies so that no pair of bodies touches at any time. Excepted are the pairs in `overlapping`,
/// which the engine has to part and which are not held back because of each other, and features that touch at t=0
/// already (AtStart::ignore). If a pair touches later, both bodies are held back by the same part, to about `gap`
/// before the contact; a pair that starts nearer than that may come half as near. Then the question is asked again, as
/// bodies that move less meet others elsewhere. Bodies far from any contact go all their way. Leaves `world` with the
/// proven motions, after an exception with those of before. Throws InvalidOptions if an option is out of its range, and
/// what World throws.
ClampedStep clamp(World& world, const WantedStep& step, const std::set<BodyPair>& overlapping,
                  const ClampOptions& options = {});

}  // namespace tamis::adapters
