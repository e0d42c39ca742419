#include <cstdio>
#include <tamis/tamis.hpp>

int main() {
  // a straight rod of ten edges of length 1 that stands still, and a separation of 1.5
  std::vector<tamis::Point> x;
  std::vector<tamis::Edge> edges;
  for (int v = 0; v <= 10; ++v) {
    x.push_back({double(v), 0, 0});
    if (v > 0) edges.push_back({v - 1, v});
  }
  const tamis::Mesh mesh(11, {}, edges);
  tamis::Options options{.min_separation = 1.5};
  tamis::Detector whole(mesh, options);
  std::printf("as it is: %zu contacts\n", whole.contacts({x, x}).size());
  options.filter.rings = 2;
  tamis::Detector without_next(mesh, options);
  std::printf("without pairs that one edge joins: %zu contacts\n", without_next.contacts({x, x}).size());
}
