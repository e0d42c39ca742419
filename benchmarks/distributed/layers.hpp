// Sheets in layers that press on each other, of any size: every rank makes its own part and sees no other.
#pragma once
#include <vector>

#include "tamis/distributed.hpp"

namespace tamis::bench {

/// The part of one rank: a block of rows, in an order that goes through layer after layer, as in a simulator that knows
/// nothing of contact.
struct LayersPart {
  distributed::LocalMesh mesh;
  std::vector<Point> start, end, apart;

  Step step() const { return {start, end}; }
  Step back() const { return {end, start}; }
  /// Starts from waves that are too low to meet, so that the first contact comes late.
  Step closing() const { return {apart, end}; }
};

/// Makes the rank's part of about `triangles` in all, in eight layers. The number of contacts per triangle does not
/// depend on `triangles`.
LayersPart make_layers(double triangles, int rank, int ranks);

}  // namespace tamis::bench
