// Machines of rigid bodies whose parts are near each other all the time: rebuilt from the descriptions of the examples
// of Rigid IPC (Ferguson et al. 2021, "Intersection-free Rigid Body Dynamics"), each as one step. They use sine and
// cosine, and may differ in last places from machine to machine.
#pragma once
#include <string>
#include <vector>

#include "scenes/shapes.hpp"
#include "tamis/rigid_path.hpp"

namespace tamis::scenes {

struct MachinePart {
  std::size_t shape;  ///< of Machine::shapes
  RigidLink way;      ///< rotation vector and position are linear in time; a part that stands has the same at both ends
};

struct Machine {
  std::vector<Shape> shapes;
  std::vector<MachinePart> parts;
};

/// `count` wheels of `teeth` teeth, an even number, in a row, each in the gaps of the next; all turn, every other one
/// the other way. The last one is held if `is_jammed`.
Machine gear_train(Index count, Index teeth, double turn, bool is_jammed);

/// A nut that turns and follows the thread of a bolt, `around` cells a turn; without following it if `is_jammed`.
Machine nut_on_bolt(Index around, double turn, bool is_jammed);

/// `side` x `side` flat rings, each linked with its neighbours by upright rings. The outermost flat rings are held; all
/// others sag by `fall` and swing. Cells around a ring and around its wire: `around`, `across`.
Machine chain_net(Index side, Index around, Index across, double fall);

/// A block that flies through a tunnel little wider than itself, of `cells` x `cells` quads a side; it turns by `turn`
/// about its direction of flight; the tunnel leaves room for about 0.01. Both lie askew.
Machine tunnel(Index cells, double turn);

}  // namespace tamis::scenes
