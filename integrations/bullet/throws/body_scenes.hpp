// Scenes of many bodies under gravity, and of free ones.
#pragma once
#include "integrations/bullet/throws/bodies.hpp"

namespace tamis::bullet {

/// Square plates 1 m wide and 5 mm thick, thinner than what gravity moves one in two steps, fall onto each other on a
/// floor; at first each is `drop` metres above the next. REQUIRES: plates >= 1, drop > 0.
BodyScene pile(int plates, double drop);
/// The number of plates of a pile that end no higher than their thickness above the place of the one below.
std::size_t plates_inside(const BodyRun& run);

/// A turned box of one of three sizes falls on a floor, at 2 to 40 m/s. Each seed has its own.
BodyScene drop_of_a_box(unsigned seed);
/// A floor with four walls around a square of 2 * half_side.
BodyScene pit(btScalar half_side);
/// Thirty bodies, boxes, hulls, plates, rods and compounds, are thrown into a pit of 2 x 2 m.
BodyScene mixed_bodies(unsigned seed);
/// side^3 boxes, 0.2 m wide, begin exactly beside and on each other, on a floor.
BodyScene blocks(int side);
/// Boxes stand on a floor in stacks of four, a gap of 1 mm apart.
BodyScene stacks(int boxes, Sleep sleep);
/// A peg, 0.1 m wide, begins at the mouth of a tube that is wider by `clearance` metres on each side, and falls in it.
BodyScene peg_in_tube(double clearance);
/// How far the peg ends above the floor, in metres.
double peg_above_floor(const BodyRun& run);
/// Cubes in a row, free of gravity, 1.5 mm apart; the first comes from farther away at 5 m/s.
BodyScene row_of_cubes(int cubes);

}  // namespace tamis::bullet
