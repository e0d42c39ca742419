// Checks that a detector that has been asked before answers as a new one would, bit for bit.
#pragma once
#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "support/contact_bits.hpp"
#include "tamis/detector.hpp"

namespace tamis::test {

inline std::vector<Point> between(const std::vector<Point>& a, const std::vector<Point>& b, double t) {
  std::vector<Point> points = a;
  for (std::size_t v = 0; v < points.size(); ++v)
    for (std::size_t k = 0; k < 3; ++k) points[v][k] += t * (b[v][k] - a[v][k]);
  return points;
}

/// Three groups of vertices, two of them with a radius.
inline void give_radii(Options& options, Index vertex_count) {
  options.filter.group_count = 3;
  for (Index v = 0; v < vertex_count; ++v) options.filter.group_of_vertex.push_back(v % 3);
  options.filter.groups_may_touch.assign(9, true);
  options.radii = {0, 0x1p-6, 0x1p-5};
}

/// Near pairs and intersections, as rows of numbers.
inline std::vector<std::array<double, 8>> at_rest(Detector& detector, const Step& step) {
  std::vector<std::array<double, 8>> rows;
  for (const NearPair& p : detector.pairs_within(step.start, 0.01))
    rows.push_back({double(p.kind), double(p.vertices[0]), double(p.vertices[1]), double(p.vertices[2]),
                    double(p.vertices[3]), p.distance, p.u, p.v});
  for (const Intersection& p : detector.intersections(step.start))
    rows.push_back({double(p.edge[0]), double(p.edge[1]), double(p.face[0]), double(p.face[1]), double(p.face[2]),
                    p.s_lower, p.s_upper, p.u});
  rows.push_back({double(detector.has_intersection(step.start))});
  return rows;
}

/// The questions about a step. The first three are about contacts alone, `truncate` is the last.
enum class Asked : std::uint8_t { contacts, earliest, is_free, safe_step, at_rest, truncate };
constexpr Index kAsked = static_cast<Index>(Asked::truncate) + 1, kAskedOfContacts = 3;

/// Were the pairs of the last question listed ahead, so that it visited no trees?
inline bool was_listed(const Detector& detector) { return detector.statistics().nodes_visited == 0; }

inline void expect_as_new(Detector& kept, const Step& step, Asked question, const std::string& where,
                          const QueryOptions& own = {}) {
  Options options = kept.options();
  Detector fresh(kept.mesh(), options);
  switch (question) {
    case Asked::contacts:
      EXPECT_EQ(bits_of(kept.contacts(step, own)), bits_of(fresh.contacts(step, own))) << where;
      break;
    case Asked::earliest: {
      const EarliestContact a = kept.earliest(step, own), b = fresh.earliest(step, own);
      EXPECT_EQ(a.toi_lower, b.toi_lower) << where;
      EXPECT_EQ(a.toi_upper, b.toi_upper) << where;
      ASSERT_EQ(a.contact.has_value(), b.contact.has_value()) << where;
      if (a.contact) {
        EXPECT_EQ(bits_of(*a.contact), bits_of(*b.contact)) << where;
      }
      break;
    }
    case Asked::is_free:
      EXPECT_EQ(kept.is_free(step, own), fresh.is_free(step, own)) << where;
      break;
    case Asked::safe_step: {
      const SafeStep a = kept.safe_step(step, 0.2, own), b = fresh.safe_step(step, 0.2, own);
      EXPECT_EQ(a.toi_lower, b.toi_lower) << where;
      EXPECT_EQ(a.toi_upper, b.toi_upper) << where;
      break;
    }
    case Asked::at_rest:
      EXPECT_EQ(at_rest(kept, step), at_rest(fresh, step)) << where;
      break;
    case Asked::truncate: {
      const TruncatedStep a = kept.truncate(step, 0.1, own), b = fresh.truncate(step, 0.1, own);
      EXPECT_EQ(a.positions, b.positions) << where;
      EXPECT_EQ(a.fractions, b.fractions) << where;
    }
  }
}

}  // namespace tamis::test
