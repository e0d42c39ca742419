// One pair against the oracle: no contact missed, none made up, and the promises on its time kept; the decision does
// not depend on the order of the vertices or on the unit of length.
#include <algorithm>

#include "fuzz/moving_points.hpp"
#include "fuzz/require.hpp"
#include "support/describe.hpp"
#include "tamis/pair.hpp"

namespace tamis::fuzz {
namespace {

using oracle::Motion;

struct Pair {
  PairKind kind;
  Motion motion;
};

Pair take_pair(ByteSource& bytes) {
  Pair pair{bytes.below(2) == 0 ? PairKind::vertex_face : PairKind::edge_edge, {}};
  MovingPoints points = take_points(bytes, 4);
  place(bytes, points);
  std::copy_n(points.start.begin(), 4, pair.motion.start.begin());
  std::copy_n(points.end.begin(), 4, pair.motion.end.begin());
  return pair;
}

PairResult decide(const Pair& pair, const PairOptions& options) {
  const Motion& m = pair.motion;
  return pair.kind == PairKind::vertex_face ? vertex_face(m.start, m.end, options) : edge_edge(m.start, m.end, options);
}

/// The truth at some of the times, with a separation or without.
bool truth_of(const Pair& pair, double separation, const oracle::Times& times = {}) {
  return separation > 0 ? oracle::comes_within(pair.kind, pair.motion, separation, times)
                        : oracle::touches(pair.kind, pair.motion, times);
}

/// The same pair as another caller would give it: features exchanged (edges), vertices in another order, another unit.
Pair disguised(Pair pair, ByteSource& bytes, int exponent) {
  const int choice = bytes.below(12);
  for (auto* points : {&pair.motion.start, &pair.motion.end}) {
    auto& p = *points;
    if (pair.kind == PairKind::vertex_face) {
      std::rotate(p.begin() + 1, p.begin() + 1 + choice % 3, p.end());
      if (choice % 2 == 1) std::swap(p[1], p[2]);
    } else {
      if (choice % 2 == 1) std::swap(p[0], p[1]);
      if (choice % 4 >= 2) std::swap(p[2], p[3]);
      if (choice >= 4) std::swap(p[0], p[2]), std::swap(p[1], p[3]);
    }
    for (Point& point : p)
      for (double& x : point) x = std::ldexp(x, exponent);
  }
  return pair;
}

/// Every coordinate is zero or of a usual size, so that another unit within 2^+-200 is no rounding.
bool is_of_usual_size(const Motion& m) {
  const auto usual = [](double x) { return x == 0 || (std::abs(x) > 0x1p-30 && std::abs(x) < 0x1p30); };
  for (const auto* points : {&m.start, &m.end})
    for (const Point& p : *points)
      if (!std::all_of(p.begin(), p.end(), usual)) return false;
  return true;
}

void check(const Pair& pair, const PairOptions& options, const PairResult& r, bool truth) {
  const double separation = options.min_separation;
  const auto say = [&](bool promise, const char* what) {
    require(promise, what,
            [&] { return test::describe(pair.kind, pair.motion) + "\n  separation " + std::to_string(separation); });
  };
  say(r.touches || !truth, "missed contact");
  say(truth || !r.touches, "touches, but free");
  say(r.certainty == Certainty::certified, "not certified");
  if (!r.touches) return;
  say(0 <= r.toi_lower && r.toi_lower <= r.toi_upper && r.toi_upper <= 1, "no bracket within the step");
  say(r.toi_lower == 0 || !truth_of(pair, separation, {0, r.toi_lower, true}), "touches before toi_lower");
  say(truth_of(pair, separation, {r.toi_lower, r.toi_upper}), "does not touch within the bracket");
  say(r.u >= 0 && r.v >= 0 && r.u <= 1 && r.v <= 1, "weights outside the features");
}

void check_disguised(const Pair& pair, const Pair& other, bool truth) {
  const auto describe = [&] { return test::describe(pair.kind, pair.motion); };
  require(decide(other, {}).touches == truth, "the order of vertices, or the unit, changes the answer", describe);
}

void check_unit(const Pair& pair, int exponent, ByteSource& bytes) {
  ByteSource unchanged{{}};
  const Pair same = disguised(pair, unchanged, 0), other = disguised(pair, unchanged, exponent);
  const PairResult a = decide(same, {}), b = decide(other, {});
  require(a.touches == b.touches, "the unit of length changes the decision", [&] {
    return test::describe(pair.kind, pair.motion) + "\n  times two to the power " + std::to_string(exponent);
  });
  check_disguised(pair, disguised(pair, bytes, exponent), oracle::touches(pair.kind, pair.motion));
}

void check_separation(const Pair& pair, double separation) {
  const PairOptions options{separation};
  check(pair, options, decide(pair, options), truth_of(pair, separation));
}

}  // namespace
}  // namespace tamis::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tamis::fuzz;
  ByteSource bytes({data, size});
  const Pair pair = take_pair(bytes);
  const bool truth = truth_of(pair, 0);
  check(pair, {}, decide(pair, {}), truth);
  if (!is_of_usual_size(pair.motion)) return 0;  // the oracle's degree six would take its time
  check_unit(pair, bytes.take<std::int8_t>() * 200 / 128, bytes);
  if (bytes.below(4) == 3) check_separation(pair, std::ldexp(1 + bytes.below(16), -bytes.below(24)));
  return 0;
}
