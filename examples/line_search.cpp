#include <cmath>
#include <cstdio>
#include <tamis/tamis.hpp>

using Positions = std::vector<tamis::Point>;

/// Goes from x along the way so far that the energy falls and every pair keeps a tenth of its distance.
template <class Energy>
double line_search(tamis::Detector& detector, Positions& x, const Positions& way, const Energy& energy) {
  const auto at = [&](double t) {
    Positions y = x;
    for (std::size_t v = 0; v < y.size(); ++v)
      for (std::size_t axis = 0; axis < 3; ++axis) y[v][axis] += t * way[v][axis];
    return y;
  };
  const Positions end = at(1);
  const double now = energy(x);
  for (double t = detector.safe_step({x, end}, 0.1).toi_lower; t > 1e-12; t /= 2)
    if (Positions y = at(t); energy(y) < now) return x = y, t;
  return 0;
}

int main() {
  // a triangle, and a point above it that is pulled down; a logarithm holds it up within 0.1
  tamis::Detector detector(tamis::Mesh(4, {{0, 1, 2}}, {}, {3}));
  Positions x{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.2, 1}};
  const double reach = 0.1;
  const auto energy = [&](const Positions& y) {
    double sum = y[3][2];
    for (const tamis::NearPair& pair : detector.pairs_within(y, reach))
      sum -= 1e-2 * std::pow(1 - pair.distance / reach, 2) * std::log(pair.distance / reach);
    return sum;
  };
  const auto slope = [&] {
    Positions above = x, below = x;
    above[3][2] += 1e-6;
    below[3][2] -= 1e-6;
    return (energy(above) - energy(below)) / 2e-6;
  };
  for (int i = 0; i < 100; ++i) line_search(detector, x, {{}, {}, {}, {0, 0, -slope()}}, energy);
  std::printf("it rests %.4f above the triangle\n", x[3][2]);
}
