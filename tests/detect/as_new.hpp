// Does a detector that has been asked before answer as a new one would, bit for bit?
#pragma once
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "tamis/detector.hpp"

namespace tamis::test {

/// Every number of every contact.
inline std::vector<std::array<double, 12>> bits_of(const std::vector<Contact>& contacts) {
  std::vector<std::array<double, 12>> rows;
  for (const Contact& c : contacts)
    rows.push_back({double(c.kind), double(c.certainty), double(c.vertices[0]), double(c.vertices[1]),
                    double(c.vertices[2]), double(c.vertices[3]), c.toi_lower, c.toi_upper, c.u, c.v,
                    c.normal[0] + 2 * c.normal[1], c.normal[2]});
  return rows;
}

inline std::vector<Point> between(const std::vector<Point>& a, const std::vector<Point>& b, double t) {
  std::vector<Point> points = a;
  for (std::size_t v = 0; v < points.size(); ++v)
    for (std::size_t k = 0; k < 3; ++k) points[v][k] += t * (b[v][k] - a[v][k]);
  return points;
}

/// `question`: contacts, earliest, is_free, keep_distance.
inline void expect_as_new(Detector& kept, const Step& step, Index question, const std::string& where) {
  Options options = kept.options();
  Detector fresh(kept.mesh(), options);
  if (question == 0) {
    EXPECT_EQ(bits_of(kept.contacts(step)), bits_of(fresh.contacts(step))) << where;
  } else if (question == 1) {
    const EarliestContact a = kept.earliest(step), b = fresh.earliest(step);
    EXPECT_EQ(a.toi_lower, b.toi_lower) << where;
    EXPECT_EQ(a.toi_upper, b.toi_upper) << where;
    ASSERT_EQ(a.contact.has_value(), b.contact.has_value()) << where;
    if (a.contact) {
      EXPECT_EQ(bits_of({*a.contact}), bits_of({*b.contact})) << where;
    }
  } else if (question == 2) {
    EXPECT_EQ(kept.is_free(step), fresh.is_free(step)) << where;
  } else {
    const SafeStep a = kept.keep_distance(step, 0.2), b = fresh.keep_distance(step, 0.2);
    EXPECT_EQ(a.lower, b.lower) << where;
    EXPECT_EQ(a.upper, b.upper) << where;
  }
}

}  // namespace tamis::test
