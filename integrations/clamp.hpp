// For engines of rigid bodies: how much of the step that an engine wants to make it may make, so that no two bodies
// pass through each other. This file knows no engine; integrations/bullet shows what an engine must provide.
#pragma once
#include <set>
#include <vector>

#include "integrations/near_contacts.hpp"

namespace tamis::adapters {

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

/// What a body does in a clamped step.
struct BodyEnd {
  double fraction;    ///< the part of its way that it may go, in [0, 1]
  Velocity velocity;  ///< with which it begins the next step
};

struct ClampedStep {
  std::vector<BodyEnd> ends;  ///< one for each body of moving()
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
std::set<BodyPair> overlapping(World& world, const Bodies& bodies);

/// How bodies are to each other when a step begins.
struct Beginning {
  std::set<BodyPair> overlapping;
  Near near;  ///< within two gaps
};
/// Where the world's motions begin. `are_apart`: the last step ended here, and was proven for all pairs: then only
/// bodies that are too near to tell may overlap.
Beginning beginning(World& world, const Bodies& bodies, const ClampOptions& options = {}, bool are_apart = false);

/// The policy for all engines. Throws InvalidOptions if an option is out of its range, and what World throws.
///
/// 1. Bodies that lie on others (Carriers) lose the speed by which they would come nearer than a gap, and are moved
///    apart where they are nearer. So bodies come to rest whether or not the engine's solver sees their contacts.
/// 2. Ways are shortened until no pair of bodies touches at any time. Excepted are the pairs in `overlapping`, which
///    the engine has to part, and features that touch at t=0 already (AtStart::ignore). If a pair touches later, both
///    bodies are held back by the same part, to about `gap` before the contact. A pair that starts nearer than that may
///    come half as near. Then the query runs again, because bodies that move less meet others elsewhere. Bodies far
///    from any contact go all their way.
/// 3. Two bodies that were within two gaps when the step began, so that the engine's solver could see them, and that
///    were held back because of each other, lose the speed with which they meet. A body that goes next to nothing of
///    its way loses half of its speed.
///
/// Leaves `world` with the proven motions, after an exception with those of before.
[[nodiscard]] ClampedStep clamp(World& world, WantedStep& step, const Beginning& beginning,
                                const ClampOptions& options = {});

}  // namespace tamis::adapters
