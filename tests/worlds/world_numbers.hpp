// All that a world answers, as numbers to compare.
#pragma once
#include <vector>

#include "tamis/world.hpp"

namespace tamis::test {

using Numbers = std::vector<double>;

inline void append(Numbers& numbers, const BodyContact& c) {
  numbers.insert(numbers.end(), {double(c.bodies[0]), double(c.bodies[1]), double(c.kind), c.toi_lower, c.toi_upper,
                                 c.u, c.v, c.normal[0], c.normal[1], c.normal[2]});
  for (const Index v : c.vertices) numbers.push_back(v);
}
inline void append(Numbers& numbers, const BodyNearPair& p) {
  numbers.insert(numbers.end(), {double(p.bodies[0]), double(p.bodies[1]), double(p.kind), p.distance, p.u, p.v});
  for (const Index v : p.vertices) numbers.push_back(v);
}
inline void append(Numbers& numbers, const EarliestBodyContact& first) {
  numbers.insert(numbers.end(), {first.toi_lower, first.toi_upper});
  if (first.contact) append(numbers, *first.contact);
}

inline Numbers contacts_of(World& world) {
  Numbers numbers;
  for (const BodyContact& c : world.contacts()) append(numbers, c);
  return numbers;
}

/// `bodies`: those that there are. REQUIRES: a distance that is the same double wherever it is given.
inline Numbers numbers_of(World& world, const std::vector<BodyId>& bodies, double distance) {
  Numbers numbers = contacts_of(world);
  append(numbers, world.earliest());
  append(numbers, world.earliest({.min_separation = distance}));
  numbers.push_back(world.is_free());
  for (const double keep : {0.0, 0.25}) {
    const BodyStep step = world.safe_step(keep);
    numbers.insert(numbers.end(), {step.toi_lower, step.toi_upper});
    if (step.pair) append(numbers, *step.pair);
  }
  for (const BodyNearPair& pair : world.pairs_within(distance)) append(numbers, pair);
  for (const BodyIntersection& i : world.intersections())
    numbers.insert(numbers.end(), {i.s_lower, i.s_upper, i.u, i.v, double(i.bodies[0]), double(i.bodies[1])});
  numbers.push_back(world.has_intersection());
  numbers.push_back(world.has_overlap());
  for (const BodyId body : bodies) {
    numbers.push_back(static_cast<double>(world.motion(body).index()));
    for (const double time : {0.0, 0.375, 1.0}) {
      const BodyPoints at = world.points_at(body, time);
      for (const Point& p : at.points) numbers.insert(numbers.end(), p.begin(), p.end());
      numbers.push_back(at.error);
    }
  }
  return numbers;
}

}  // namespace tamis::test
