// Helpers for the rows of the table, and the functions that print them.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "scenes/shapes.hpp"
#include "tamis/world.hpp"

namespace tamis::worlds {

struct Cost {
  double median, mean;
};

/// Milliseconds: of one thread processor time, of more the wall clock. The first steps warm up. `ask()` is timed,
/// `move(step)` is not.
Cost milliseconds(int steps, const std::function<void(int)>& move, const std::function<void()>& ask);

void print_row(const std::string& what, std::size_t answers, const Cost& cost);

/// Sets the number of threads for all rows. The default is 1.
void set_threads(int threads);
Options options();

/// A grid of `cells` x `cells` squares of side `edge`, centred at the origin, with height(x, y).
scenes::Shape sheet(Index cells, double edge, const std::function<double(double, double)>& height);
/// The height of a wavy floor.
double floor_height(double x, double y);
Shape shape_of(const scenes::Shape& shape);

// The rows, `steps` steps each.
void two_large_bodies(int steps);
void many_bodies(int count, int steps);
void balls_above_a_ground(int steps);
void safe_steps_beside_a_far_flight(int steps);
/// `which`: nut, or all of them.
void machines(const std::string& which, int steps);
void plates(int steps);
void many_radii(int count, int steps);
void room(int steps);
void arm(int steps);

}  // namespace tamis::worlds
