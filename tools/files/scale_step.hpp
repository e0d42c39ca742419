// A step made longer or shorter.
#pragma once
#include <vector>

#include "tamis/step.hpp"

namespace tamis::io {

/// start + part (end - start). Overflows only where that does.
double part_of_way(double start, double end, double part);

/// Moves every end to start + scale (end - start); 1 leaves it bit for bit. Throws InvalidOptions if one
/// overflows.
void scale_step(const std::vector<Point>& start, std::vector<Point>& end, double scale);

}  // namespace tamis::io
