#include "benchmarks/distributed/layers.hpp"

#include <cmath>
#include <map>

namespace tamis::bench {
namespace {

constexpr Index kLayers = 8;

/// The position of a vertex, in units of an edge. Waves are twenty edges long, and turned over in every other layer, so
/// that crests press into crests.
Point at(Index layer, Index row, Index column, double slide, double height) {
  constexpr double kWave = 0.31, kApart = 0.5;
  const double side = layer % 2 == 0 ? 1 : -1, x = row + side * slide, y = column + 0.37 * layer;
  return {x, y, kApart * layer + side * height * std::sin(kWave * x) * std::cos(kWave * y)};
}

class Maker {
 public:
  explicit Maker(Index side) : side_(side) {}

  void add_row(Index layer, Index row) {
    for (Index column = 0; column < side_; ++column) {
      const Index a = vertex(layer, row, column), b = vertex(layer, row, column + 1);
      const Index c = vertex(layer, row + 1, column), d = vertex(layer, row + 1, column + 1);
      part_.mesh.faces.push_back({a, b, d});
      part_.mesh.faces.push_back({a, d, c});
    }
  }

  LayersPart take() {
    for (const auto& [number, motion] : given_) {
      part_.mesh.vertices.push_back(number);
      part_.start.push_back(motion[0]);
      part_.end.push_back(motion[1]);
      part_.apart.push_back(motion[2]);
    }
    return std::move(part_);
  }

 private:
  Index vertex(Index layer, Index row, Index column) {
    const Index number = (layer * (side_ + 1) + row) * (side_ + 1) + column;
    constexpr double kSlide = 0.4, kHigh = 0.28, kLow = 0.2;
    given_.try_emplace(number, std::array{at(layer, row, column, 0, kHigh), at(layer, row, column, kSlide, kHigh),
                                          at(layer, row, column, 0, kLow)});
    return number;
  }

  const Index side_;
  LayersPart part_;
  std::map<Index, std::array<Point, 3>> given_;
};

}  // namespace

LayersPart make_layers(double triangles, int rank, int ranks) {
  const auto side = static_cast<Index>(std::lround(std::sqrt(triangles / (2 * kLayers))));
  Maker maker(side);
  const std::int64_t rows = std::int64_t{kLayers} * side;
  for (std::int64_t row = rows * rank / ranks; row < rows * (rank + 1) / ranks; ++row)
    maker.add_row(static_cast<Index>(row / side), static_cast<Index>(row % side));
  return maker.take();
}

}  // namespace tamis::bench
