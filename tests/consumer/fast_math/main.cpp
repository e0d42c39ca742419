// Prints the bits of many answers. Compiled with -ffast-math or without, in a library that is or is not a part of such
// a project, they are the same. Inputs are small integers times powers of two: no option changes them.
#include <bit>
#include <cinttypes>
#include <cstdio>
#include <random>
#include <tamis/tamis.hpp>

namespace {

void print(double x) { std::printf(" %016" PRIx64, std::bit_cast<std::uint64_t>(x)); }

void print(const tamis::PairResult& r) {
  std::printf("%d", r.touches);
  if (r.touches)
    for (const double x : {r.toi_lower, r.toi_upper, r.u, r.v, r.normal[0], r.normal[1], r.normal[2]}) print(x);
  std::printf("\n");
}

/// Of a double whose lowest bit may be 2^-1074, made without arithmetic.
double subnormal(std::uint64_t units) { return std::bit_cast<double>(units); }

using Four = std::array<tamis::Point, 4>;

}  // namespace

int main() {
  std::mt19937 random(1);
  const auto lattice = [&] {
    Four points;
    for (tamis::Point& p : points)
      for (double& x : p) x = static_cast<double>(static_cast<int>(random() % 9) - 4);
    return points;
  };
  const auto tiny = [&] {
    Four points;
    for (tamis::Point& p : points)
      for (double& x : p) x = subnormal(random() % 4096);
    return points;
  };
  for (int i = 0; i < 20000; ++i) {
    const Four start = lattice(), end = lattice();
    print(tamis::vertex_face(start, end));
    print(tamis::edge_edge(start, end, {.min_separation = i % 3 * 0.125}));
  }
  for (int i = 0; i < 500; ++i) {
    const Four start = tiny(), end = tiny();
    print(tamis::vertex_face(start, end));
    print(tamis::edge_edge(start, end, {.min_separation = subnormal(static_cast<std::uint64_t>(i % 3))}));
  }
  std::vector<tamis::Point> starts, ends;  // of so many pairs that threads share them, if there are threads
  for (int i = 0; i < 20000; ++i)
    for (auto* points : {&starts, &ends}) {
      const Four four = lattice();
      points->insert(points->end(), four.begin(), four.end());
    }
  std::vector<tamis::PairResult> results(starts.size() / 4);
  tamis::narrow_phase(tamis::PairKind::edge_edge, starts, ends, results);
  for (const tamis::PairResult& result : results) print(result);
  Four start = lattice();
  start[1][1] = std::bit_cast<double>(std::uint64_t{0x7ff8000000000000});  // not a number
  try {
    print(tamis::vertex_face(start, start));
  } catch (const tamis::InvalidStep& refused) {
    std::printf("refused: %s\n", refused.what());
  }
}
