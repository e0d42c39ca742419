// The exact decision against two answers that need no solver, so that many millions of cases can be run: contacts made
// on purpose, and pairs that a fixed plane keeps apart. TAMIS_EXACT_STRESS sets the number of cases of each.
#include <gtest/gtest.h>

#include "numbers/vec.hpp"
#include "pair/exact/exact.hpp"
#include "support/pair_cases.hpp"
#include "support/test_data.hpp"

namespace tamis::test {
namespace {

using oracle::Motion;

Vec3<double> to_vec(const Point& p) { return {p[0], p[1], p[2]}; }
Vec3<double> at(const Motion& m, std::size_t i, double t) {
  return (1 - t) * to_vec(m.start[i]) + t * to_vec(m.end[i]);
}

PairKind random_kind(Random& random) { return random.coin() ? PairKind::vertex_face : PairKind::edge_edge; }

/// Multiples of 1/16; on few points as often as on many.
Motion on_lattice(Random& random) {
  const Index steps = random.coin() ? 2 : 1000;
  Motion m;
  for (auto* points : {&m.start, &m.end})
    for (Point& p : *points) p = random.point_on_lattice(steps, 0.0625);
  return m;
}

/// 0, 1/8, .. 1; the ends in half of the cases.
double eighths(Random& random) { return random.coin() ? random.below(2) : random.below(9) * 0.125; }

/// Features of a pair: its first `split` points, and the others.
std::size_t split(PairKind kind) { return kind == PairKind::vertex_face ? 1 : 2; }

/// Moves the first feature as a whole so that the two touch at time `t`. All numbers are short: nothing is rounded.
void make_touch(PairKind kind, Motion& m, double t, Random& random) {
  const double u = eighths(random), v = eighths(random) * (kind == PairKind::vertex_face ? 1 - u : 1);
  const auto gap = kind == PairKind::vertex_face
                       ? (1 - u - v) * at(m, 1, t) + u * at(m, 2, t) + v * at(m, 3, t) - at(m, 0, t)
                       : (1 - u) * at(m, 2, t) + u * at(m, 3, t) - (1 - v) * at(m, 0, t) - v * at(m, 1, t);
  for (auto* points : {&m.start, &m.end})
    for (std::size_t i = 0; i < split(kind); ++i) {
      const auto moved = to_vec((*points)[i]) + gap;
      (*points)[i] = {moved.x, moved.y, moved.z};
    }
}

// Catches a missed contact, or a first time after a contact.
TEST(ExactStress, no_contact_made_on_purpose_is_missed) {
  Random random(7);
  for (long i = repetitions("TAMIS_EXACT_STRESS", 20000); i > 0; --i) {
    const PairKind kind = random_kind(random);
    Motion m = on_lattice(random);
    const double t = eighths(random);
    make_touch(kind, m, t, random);
    const Decision decision = decide_exactly(kind, to_points(m));
    ASSERT_TRUE(decision.touches() && decision.lower <= t) << t << "\n" << describe(kind, m);
  }
}

// Catches a false contact: the features stay on their sides of a plane, from which they are 0 and 2^-30 apart.
TEST(ExactStress, no_pair_kept_apart_by_a_plane_touches) {
  Random random(8);
  for (long i = repetitions("TAMIS_EXACT_STRESS", 20000); i > 0; --i) {
    const PairKind kind = random_kind(random);
    Motion m = on_lattice(random);
    const double slope_y = random.on_lattice(4, 0.25), slope_z = random.on_lattice(4, 0.25);
    for (auto* points : {&m.start, &m.end})
      for (std::size_t k = 0; k < 4; ++k) {
        Point& p = (*points)[k];
        const double above = random.coin() ? 0 : random.below(3) * 0.5, side = k < split(kind) ? 1 : -1;
        p[0] = slope_y * p[1] + slope_z * p[2] + side * above + (k < split(kind) ? 0x1p-30 : 0);
      }
    ASSERT_FALSE(decide_exactly(kind, to_points(m)).touches()) << describe(kind, m);
  }
}

}  // namespace
}  // namespace tamis::test
