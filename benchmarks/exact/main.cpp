// tamis_exact [COUNT]: the cost of exact algebra for one pair, for each family of motions
// (tests/support/pair_cases.hpp), for coordinates of very different exponents, and with a minimum separation.
// Microseconds a call, the least of three.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "pair/exact/exact.hpp"
#include "support/ask_pair.hpp"
#include "support/pair_cases.hpp"

namespace tamis::bench {
namespace {

using test::Random;

double microseconds(PairKind kind, const PairPoints& points, double separation) {
  double least = 1e300;
  for (int turn = 0; turn < 3; ++turn) {
    const auto start = std::chrono::steady_clock::now();
    const Decision decision = decide_exactly(kind, points, separation);
    const std::chrono::duration<double, std::micro> time = std::chrono::steady_clock::now() - start;
    least = decision.lower <= decision.upper ? std::min(least, time.count()) : least;
  }
  return least;
}

void print_row(const std::string& name, std::vector<double> times) {
  std::sort(times.begin(), times.end());
  double sum = 0;
  for (const double t : times) sum += t;
  const auto at = [&](double fraction) {
    return times[static_cast<std::size_t>(fraction * static_cast<double>(times.size() - 1))];
  };
  std::printf("%-38s %9.2f %9.2f %9.2f %9.2f\n", name.c_str(), sum / static_cast<double>(times.size()), at(0.5),
              at(0.99), times.back());
}

/// `spread`: multiplies every coordinate by its own random power of two, within 2^+-spread.
void run(const std::string& name, const test::Family& family, int count, int spread, bool is_separated) {
  Random random(1);
  std::vector<double> times;
  for (int i = 0; i < count; ++i)
    for (const PairKind kind : {PairKind::vertex_face, PairKind::edge_edge}) {
      PairPoints points = test::to_points(family.make(kind, random));
      if (spread > 0)
        for (auto* at : {&points.start, &points.end})
          for (Point& point : *at)
            for (double& x : point) x = std::ldexp(x, static_cast<int>(random.below(2 * spread)) - spread);
      times.push_back(microseconds(kind, points, is_separated ? 0.125 * (1 + random.below(8)) : 0));
    }
  print_row(name, std::move(times));
}

}  // namespace
}  // namespace tamis::bench

int main(int argc, char** argv) {
  using namespace tamis;
  const int count = argc > 1 ? std::atoi(argv[1]) : 1000;
  std::printf("%-38s %9s %9s %9s %9s\n", "microseconds a pair", "mean", "median", "99%", "largest");
  for (const auto& family : test::kFamilies) bench::run(std::string(family.name), family, count, 0, false);
  const auto& random = test::family_named("random");
  bench::run("exponents within 2^+-60", random, count, 60, false);
  bench::run("exponents within 2^+-1000", random, std::max(1, count / 10), 1000, false);
  for (const auto& family : test::kFamilies)
    bench::run(std::string(family.name) + ", separated", family, count, 0, true);
  bench::run("exponents within 2^+-60, separated", random, std::max(1, count / 10), 60, true);
  bench::run("exponents within 2^+-1000, separated", random, std::max(1, count / 50), 1000, true);
}
