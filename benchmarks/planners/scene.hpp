// A six-axis arm beside a table, below a board and among balls, and edges between its configurations.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "scenes/shapes.hpp"
#include "tamis/linkage.hpp"

namespace tamis::planners {

inline constexpr std::size_t kAxes = 6;

struct Scene {
  std::vector<scenes::Shape> links;                    ///< one for each joint, in the joint's frame
  std::vector<Joint> joints;                           ///< each after the one that carries it
  std::vector<std::array<std::size_t, 2>> self_pairs;  ///< links that may touch
  std::vector<scenes::Shape> obstacles;                ///< where they stand
};

/// Edges, one configuration after the other.
struct Edges {
  std::vector<double> starts, ends;
  std::size_t count() const { return starts.size() / kAxes; }
};

/// `triangles`: about as many in each link and each ball.
Scene make_scene(int triangles);
/// Each number of the start is random in +- 2.5 radians. The end is as far away in all numbers together as `radians`;
/// 0: at another such configuration.
Edges random_edges(std::size_t count, double radians, std::uint64_t seed);

/// What one method says of the edges.
struct Answer {
  std::string method;
  std::vector<bool> is_free;
  double seconds;
};

/// Tests `states` configurations of each edge, of which the last is its end, in the order of bisection, until one
/// collides (coal, one thread). Empty if this was built without coal.
std::vector<Answer> sampled(const Scene& scene, const Edges& edges, const std::vector<int>& states);

}  // namespace tamis::planners
