#include <cstdio>
#include <tamis/tamis.hpp>

int main() {
  // a triangle, a point that lies on it within the separation, and two steps: it jumps up, and comes back
  std::vector<tamis::Point> x{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.2, 0.05}}, end = x;
  tamis::Detector detector(tamis::Mesh(4, {{0, 1, 2}}, {}, {3}), {.min_separation = 0.1});
  const tamis::QueryOptions ignore{.at_start = tamis::AtStart::ignore};
  for (const double height : {0.3, 0.0}) {
    end[3][2] = height;
    std::printf("may go %.3f of the step, ", detector.safe_step({x, end}, 0).toi_lower);
    std::printf("%.3f if what touches at the start is ignored\n", detector.safe_step({x, end}, 0, ignore).toi_lower);
    x = end;
  }
}
