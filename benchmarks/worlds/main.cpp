// The cost of bodies in a world: a Markdown table; medians over steps, each of which begins where the last one ended.
// tamis_worlds [STEPS [WHICH [THREADS]]]
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "worlds/rows.hpp"

/// WHICH: two, many (or one of its numbers of bodies), far, machines (or nut), plates, radii, room, arm; default: all.
int main(int count, char** arguments) {
  using namespace tamis::worlds;
  const std::string named = count > 2 ? arguments[2] : "all", which = named == "all" ? "" : named;
  const int steps = std::max(1, count > 1 ? std::atoi(arguments[1]) : 20);
  set_threads(std::max(1, count > 3 ? std::atoi(arguments[3]) : 1));
  if (which != "arm") std::printf("| question | answers | ms, median | mean |\n|---|--:|--:|--:|\n");
  if (which.empty() || which == "two") two_large_bodies(steps);
  for (const int bodies : {1000, 10000})
    if (which.empty() || which == "many" || which == std::to_string(bodies)) many_bodies(bodies, steps);
  if (which.empty() || which == "far") {
    balls_above_a_ground(steps);
    safe_steps_beside_a_far_flight(steps);
  }
  if (which.empty() || which == "machines" || which == "nut") machines(which, steps);
  if (which.empty() || which == "plates") plates(steps);
  if (which.empty() || which == "radii") many_radii(20000, steps);
  if (which.empty() || which == "room") room(steps);
  if (which.empty() || which == "arm") arm(steps);
  return 0;
}
