// Whole scenes that pass through one line, one point or one plane: thousands of pairs touch at one time, and only
// integers know the time of each. The first contact must not cost as much as all of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "support/contact_sets.hpp"
#include "support/copied.hpp"
#include "support/thread_seconds.hpp"
#include "tamis/detector.hpp"

namespace tamis::test {
namespace {

struct Motion {
  const char* name;
  std::function<Point(const Point&)> end;
  double time;              ///< when all meet
  double part_by_integers;  ///< of what a question for all contacts leaves to integers
};

const Motion kMotions[] = {
    {"a half turn",
     [](const Point& p) {
       return Point{-p[0], -p[1], p[2]};
     },
     0.5, 0.05},
    {"through a point",
     [](const Point& p) {
       return Point{-p[0], -p[1], -p[2]};
     },
     0.5, 0.05},
    {"an axis flipped",
     [](const Point& p) {
       return Point{-p[0], p[1], p[2]};
     },
     0.5, 0.8},
    {"to a point",
     [](const Point&) {
       return Point{0, 0, 0};
     },
     1, 0.05},
    {"to a line",
     [](const Point& p) {
       return Point{0, 0, p[2]};
     },
     1, 0.5},
    {"through a point, turned",
     [](const Point& p) {
       return Point{-2 * p[1], 2 * p[0], -2 * p[2]};
     },
     1, 1},
    {"a half turn about no axis of coordinates",
     [](const Point& p) {
       const double along = 2 * (p[0] * 2 + p[1] * 3 + p[2] * 6) / 49;
       return Point{2 * along - p[0], 3 * along - p[1], 6 * along - p[2]};
     },
     0.5, 0.05},
};

struct Sheets {
  int n;
  std::vector<Point> start, end;
  std::vector<Face> faces;

  Sheets(int side, const Motion& motion) : n(side) {
    for (const double height : {0.0, 0.5})
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          const double x = 2.0 * i / (n - 1) - 1, y = 2.0 * j / (n - 1) - 1;
          start.push_back({x, y, height + 0.05 * std::sin(9 * x) * std::cos(7 * y)});
        }
    for (const Point& p : start) end.push_back(motion.end(p));
    for (int first : {0, n * n})
      for (int i = 0; i + 1 < n; ++i)
        for (int j = 0; j + 1 < n; ++j) {
          const Index a = first + i * n + j;
          faces.push_back({a, a + 1, a + n + 1});
          faces.push_back({a, a + n + 1, a + n});
        }
  }
  Detector detector(int threads = 1, Isa isa = Isa::best) const {
    Options options;
    options.threads = threads;
    options.isa = isa;
    return Detector(Mesh(2 * n * n, faces), options);
  }
  Step step() const { return {start, end}; }
};

TEST(Crowd, TheFirstContactIsRightAndTakesFewIntegers) {
  for (const Motion& motion : kMotions) {
    SCOPED_TRACE(motion.name);
    const Sheets sheets(8, motion);
    Detector detector = sheets.detector();
    const std::vector<Contact> all = copied(detector.contacts(sheets.step()));
    const auto by_integers = static_cast<double>(detector.statistics().decided_by.exact);
    const EarliestContact first = detector.earliest(sheets.step());
    ASSERT_TRUE(first.contact);
    EXPECT_TRUE(names_of(all).contains({first.contact->kind, first.contact->vertices}));
    for (const Contact& c : all) ASSERT_LE(first.toi_lower, c.toi_lower);
    EXPECT_LE(first.toi_lower, motion.time);
    EXPECT_GE(first.toi_upper, first.contact->toi_lower);
    EXPECT_LE(first.toi_upper - first.toi_lower, 1e-11);
    EXPECT_LE(static_cast<double>(detector.statistics().decided_by.exact), motion.part_by_integers * by_integers + 200);
  }
}

TEST(Crowd, NeitherThreadsNorInstructionsChangeTheAnswer) {
  for (const Motion& motion : kMotions) {
    SCOPED_TRACE(motion.name);
    const Sheets sheets(7, motion);
    const EarliestContact one = sheets.detector().earliest(sheets.step());
    for (const int threads : {1, 2, 5})
      for (const Isa isa : {Isa::best, Isa::baseline}) {
        Detector detector = sheets.detector(threads, isa);
        for (int again = 0; again < 2; ++again) {
          const EarliestContact other = detector.earliest(sheets.step());
          ASSERT_EQ(other.contact.has_value(), one.contact.has_value());
          EXPECT_EQ(other.toi_lower, one.toi_lower);
          EXPECT_EQ(other.toi_upper, one.toi_upper);
          ASSERT_TRUE(one.contact);
          EXPECT_EQ(other.contact->vertices, one.contact->vertices);
        }
      }
  }
}

/// Processor time of all threads, so that other programs do not count. (On Windows std::clock() is a wall clock.)
double seconds() { return seconds_by(CLOCK_PROCESS_CPUTIME_ID); }

TEST(Crowd, CancellingIsAskedForAllTheTime) {
  const Sheets sheets(10, kMotions[0]);
  double last = seconds(), longest = 0;
  long looks = 0;
  Options options;
  options.threads = 1;
  options.is_cancelled = [&] {
    longest = std::max(longest, seconds() - last);
    last = seconds();
    ++looks;
    return false;
  };
  Detector detector(Mesh(2 * sheets.n * sheets.n, sheets.faces), options);
  last = seconds();
  EXPECT_FALSE(detector.contacts(sheets.step()).empty());
  EXPECT_TRUE(detector.earliest(sheets.step()).contact);
  EXPECT_GT(looks, 10000);
  EXPECT_LT(std::max(longest, seconds() - last), 0.05);
}

}  // namespace
}  // namespace tamis::test
