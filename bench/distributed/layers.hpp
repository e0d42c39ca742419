// Sheets in layers that press on each other, of any size: every rank makes its own part and sees no other.
#pragma once
#include <vector>

#include "tamis/distributed.hpp"

namespace tamis::bench {

/// The part of one rank, by blocks of rows, layer after layer: the numbering of a simulator that knows nothing of
/// contact.
struct LayersPart {
  distributed::LocalMesh mesh;
  std::vector<Point> start, end, apart;

  Step step() const { return {start, end}; }
  Step back() const { return {end, start}; }
  /// From waves that are too low to meet: the first contact comes late.
  Step closing() const { return {apart, end}; }
};

/// About `triangles` in all, in eight layers; contacts per triangle do not depend on the number.
LayersPart make_layers(double triangles, int rank, int ranks);

}  // namespace tamis::bench
