// Pairs of moving bodies, and the contenders that find when two bodies first touch. Answers are compared with the truth
// before times count.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "scenes/shapes.hpp"

namespace tamis::bench {

/// x goes to R(t turn) x + from + t (to - from), t in [0,1]: constant speed about a fixed axis through the origin of
/// the body, by less than half a turn. Motions of FCL (InterpMotion), Bullet and parry have this form, too.
struct MovingBody {
  scenes::Shape shape;
  Point from, to, turn;
};

struct MovingPair {
  MovingBody first, second;  ///< apart at t=0
};

struct BodyScene {
  std::string name;
  bool is_convex;  ///< both bodies are the convex hulls of their corners, with the faces as surface
  bool turns;
  std::vector<MovingPair> pairs;
};

/// The scenes, with `pairs` pairs each; scenes of meshes have a tenth, at least one.
std::vector<BodyScene> body_scenes(int pairs);

/// By conservative advancement in long double over all pairs of features (tests/oracle). Above 1: never.
double true_first_contact(const MovingPair& pair);

/// Returned if nothing touches, and by a contender that has no answer.
constexpr double kNever = 2, kNoAnswer = -1;

class BodyContender {
 public:
  virtual ~BodyContender() = default;
  virtual std::string name() const = 0;
  virtual bool knows(const BodyScene& scene) const = 0;
  /// Takes a pair and builds what its shapes need once; not timed.
  virtual void take(const MovingPair& pair, bool is_convex) = 0;
  /// The time at which the taken pair first touches. The motion is handed over here, as in each step.
  virtual double first_contact() = 0;
};

using BodyContenders = std::vector<std::unique_ptr<BodyContender>>;
/// Each adds its contenders; those whose package was not found at build time are not compiled.
void add_tamis(BodyContenders& list);
void add_fcl(BodyContenders& list);
void add_bullet(BodyContenders& list);
void add_parry(BodyContenders& list);

}  // namespace tamis::bench
