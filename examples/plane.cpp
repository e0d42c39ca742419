#include <cstdio>
#include <tamis/tamis.hpp>

int main() {
  // a ground of two edges, a bar above it that falls while it turns, and a particle that goes faster
  std::vector<tamis::Point> start{{-4, 0, 0}, {0, -1, 0}, {4, 0, 0}, {-1, 3, 0}, {1, 3, 0}, {3, 4, 0}};
  auto end = start;
  end[3] = {-1, -3, 0};
  end[4] = {1, -1, 0};
  end[5] = {3, -4, 0};
  const tamis::Mesh mesh(6, {}, {{0, 1}, {1, 2}, {3, 4}}, {5});
  tamis::Detector detector(mesh);
  for (const auto& c : detector.contacts({start, end})) {
    const bool is_bar = c.kind == tamis::PairKind::edge_edge;
    const auto [first, second] = tamis::features_of(mesh, c.kind, c.vertices);
    std::printf("%s meets edge %d at t = %.6f\n", is_bar ? "the bar" : "the particle", is_bar ? first : second,
                c.toi_upper);
  }
  const auto safe = detector.safe_step({start, end}, 0.5);
  std::printf("half of all distances is kept until t = %.6f\n", safe.toi_lower);
}
