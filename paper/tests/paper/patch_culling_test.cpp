// High-level culling may leave out no contact, and must prove what is plainly free.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "paper/detector.hpp"
#include "scenes/scene_list.hpp"

namespace tamis::lab {
namespace {

Options with(std::string_view method) {
  Options options;
  choose_method(options, method);
  return options;
}

constexpr std::array kHighLevel{"paper-normal-cones", "paper-star-contours"};

struct Sheet {
  std::vector<Point> points;
  std::vector<Face> faces;
};

/// columns x rows squares, each place given by a function of two numbers in [0,1].
template <class Place>
Sheet sheet(Index columns, Index rows, const Place& place) {
  Sheet s;
  for (Index j = 0; j <= rows; ++j)
    for (Index i = 0; i <= columns; ++i) s.points.push_back(place(double(i) / columns, double(j) / rows));
  for (Index j = 0; j < rows; ++j)
    for (Index i = 0; i < columns; ++i) {
      const Index a = j * (columns + 1) + i, b = a + 1, c = a + columns + 1;
      s.faces.push_back({a, b, c});
      s.faces.push_back({b, c + 1, c});
    }
  return s;
}

std::vector<std::array<Index, 4>> contacts(const Sheet& at0, const Sheet& at1, std::string_view method,
                                           TriangleCounts* counts = nullptr) {
  Detector detector = make_detector(Mesh(static_cast<Index>(at0.points.size()), at0.faces), with(method), counts);
  std::vector<std::array<Index, 4>> result;
  for (const Contact& c : detector.contacts({at0.points, at1.points})) result.push_back(c.vertices);
  return result;
}

TEST(patch_culling, proves_a_waving_sheet_free_as_a_whole) {
  const auto wave = [](double phase) {
    return sheet(20, 20, [&](double x, double y) { return Point{x, y, 0.05 * std::sin(7 * x + 5 * y + phase)}; });
  };
  for (const char* method : kHighLevel) {
    TriangleCounts counts;
    EXPECT_TRUE(contacts(wave(0), wave(0.5), method, &counts).empty());
    EXPECT_EQ(counts.in_free_patches, 800U) << method;
  }
}

TEST(patch_culling, sees_the_contacts_of_a_ramp_whose_turns_lie_upon_each_other) {
  // All normals point up, so a cone alone would prove the ramp free: only the contour shows that it overlaps itself.
  const auto ramp = [](double height) {
    return sheet(60, 4, [&](double x, double y) {
      const double angle = 4 * std::numbers::pi * x, radius = 1 + y + 1e-3 * x;
      return Point{radius * std::cos(angle), radius * std::sin(angle),
                   height * angle + 0.02 * std::sin(20 * x + 9 * y)};
    });
  };
  const auto expected = contacts(ramp(0.1), ramp(-0.1), "paper");
  EXPECT_FALSE(expected.empty());
  for (const char* method : kHighLevel) EXPECT_EQ(contacts(ramp(0.1), ramp(-0.1), method), expected) << method;
}

TEST(patch_culling, leaves_out_no_contact_of_the_scenes) {
  for (const char* name : {"folded-cloth", "colliding-bodies", "sliding-sheets", "touching-spheres"})
    for (std::uint64_t seed : {1U, 2U, 3U}) {
      const scenes::Scene scene = scenes::scene_by_name(name, 800, seed);
      Detector published = make_detector(scene.mesh(), with("paper"));
      const auto expected = published.contacts(scene.step());
      for (const char* method : kHighLevel) {
        Detector detector = make_detector(scene.mesh(), with(method));
        const auto& found = detector.contacts(scene.step());
        ASSERT_EQ(found.size(), expected.size()) << name << ", seed " << seed << ", " << method;
        for (std::size_t i = 0; i < found.size(); ++i) EXPECT_EQ(found[i].vertices, expected[i].vertices);
      }
    }
}

}  // namespace
}  // namespace tamis::lab
