// What each test costs in additions, multiplications and divisions, beside the paper's figures (Du, Tang, Tong 2012:
// DNF 29/40, NCF 35/80, the elementary test 164/245/9). Ours hold the error bounds; the differences of the positions
// (18 subtractions) and comparisons are not counted. paper/README.md quotes the table that this prints.
#include <gtest/gtest.h>

#include <cstdio>
#include <random>

#include "pair/motion/make_motion.hpp"
#include "paper/filters/filters.hpp"
#include "paper/pipeline/interval_newton.hpp"
#include "support/counted.hpp"

namespace tamis::test {
namespace {

PairPoints random_points(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  PairPoints points;
  for (auto* at : {&points.start, &points.end})
    for (Point& p : *at)
      for (double& c : p) c = unit(random);
  return points;
}

Moving<Counted> counted(const Moving<double>& v) {
  const auto vec = [](const Vec3<double>& a) { return Vec3<Counted>{Counted(a.x), Counted(a.y), Counted(a.z)}; };
  return {vec(v.at0), vec(v.at1)};
}

PairMotion<Counted> counted(const PairMotion<double>& m) {
  return {counted(m.e), counted(m.f), counted(m.d), Counted(m.size_e), Counted(m.size_f), Counted(m.size_d)};
}

/// Sums over pairs, and the extremes of all operations together.
struct Tally {
  int pairs = 0;
  Operations sum, least{INT64_MAX, 0, 0}, most;

  void add(const Operations& o) {
    ++pairs;
    sum = {sum.additions + o.additions, sum.multiplications + o.multiplications, sum.divisions + o.divisions};
    const auto all = [](const Operations& x) { return x.additions + x.multiplications + x.divisions; };
    if (all(o) < all(least)) least = o;
    if (all(o) > all(most)) most = o;
  }

  void print(const char* name) const {
    const auto mean = [&](std::int64_t n) { return double(n) / pairs; };
    std::printf("%-24s mean %6.1f / %6.1f / %4.1f   least %4ld / %4ld / %2ld   most %4ld / %4ld / %2ld\n", name,
                mean(sum.additions), mean(sum.multiplications), mean(sum.divisions), long(least.additions),
                long(least.multiplications), long(least.divisions), long(most.additions), long(most.multiplications),
                long(most.divisions));
  }
};

constexpr int kPairs = 2000;

template <PairKind kind, class Test>
Tally tally(const Test& test) {
  std::mt19937_64 random(1);
  Tally result;
  for (int i = 0; i < kPairs; ++i) {
    const auto m = make_motion(kind, random_points(random));
    const auto c = counted(m);
    if (test.applies(m)) result.add(operations_of([&] { test.run(c); }));
  }
  return result;
}

template <class Filter, PairKind kind>
struct FilterTest {
  static bool applies(const PairMotion<double>&) { return true; }
  static void run(const PairMotion<Counted>& m) { Filter::template proves_free<kind>(m); }
};

/// On what DNF and NCF leave: those are the pairs that meet it.
template <PairKind kind>
struct NewtonTest {
  static bool applies(const PairMotion<double>& m) {
    return !Dnf::proves_free<kind>(m) && !lab::NcfPublished::proves_free<kind>(m);
  }
  static void run(const PairMotion<Counted>& m) { lab::interval_newton_test<kind>(m); }
};

template <class Filter>
std::array<Tally, 2> print_filter() {
  const std::string name(Filter::name);
  const std::array both{tally<PairKind::vertex_face>(FilterTest<Filter, PairKind::vertex_face>()),
                        tally<PairKind::edge_edge>(FilterTest<Filter, PairKind::edge_edge>())};
  both[0].print((name + " vf").c_str());
  both[1].print((name + " ee").c_str());
  return both;
}

TEST(operation_counts, table_of_all_tests) {
  std::printf("additions / multiplications / divisions\n");
  const auto dnf = print_filter<Dnf>();
  const auto published = print_filter<lab::NcfPublished>();
  const auto ncf = print_filter<Ncf>();
  print_filter<lab::Sat>();
  print_filter<SlabClip>();
  const auto newton_vf = tally<PairKind::vertex_face>(NewtonTest<PairKind::vertex_face>());
  const auto newton_ee = tally<PairKind::edge_edge>(NewtonTest<PairKind::edge_edge>());
  newton_vf.print("interval newton vf");
  newton_ee.print("interval newton ee");

  // The cubic: four cross products and six inner products, 29 / 42; two bounds: 2 / 4.
  EXPECT_EQ(dnf[0].most, (Operations{31, 46, 0}));
  EXPECT_EQ(dnf[0].least, dnf[0].most);
  EXPECT_EQ(dnf[1].most, dnf[0].most);
  // What the pre-test of the published NCF costs on top.
  EXPECT_GT(published[0].least.multiplications, ncf[0].least.multiplications);
  EXPECT_EQ(published[1].most, ncf[1].most);
  EXPECT_GT(newton_vf.pairs, 100);
  EXPECT_GT(newton_ee.pairs, 100);
  EXPECT_LE(newton_vf.sum.divisions, 20 * newton_vf.pairs);
}

}  // namespace
}  // namespace tamis::test
