// Frames in which objects have collapsed: one fact, in place of the pairs of all their parts.
#include "audit/collapsed.hpp"

#include <gtest/gtest.h>

#include "audit/audit.hpp"
#include "audit/tests/recorded.hpp"

namespace tamis::audit {
namespace {

constexpr int kFineSquares = 30;  // pairs of all parts of such a sheet: several million, minutes

std::vector<Point> sheet(double height) {
  return test::sheet_points(kFineSquares, [=](double x, double y) { return height + 0.05 * x * y; });
}

Report audit_of(const std::vector<std::vector<Point>>& poses, Mesh mesh) {
  const auto shared = std::make_shared<const AuditedMesh>(std::move(mesh));
  std::vector<Frame> frames;
  for (const auto& pose : poses) frames.push_back({"f" + std::to_string(frames.size()), pose, shared, {}, {}});
  test::Recorded source(std::move(frames));
  return audit(source, {.threads = 1});
}

std::vector<Point> squeezed(std::vector<Point> points, std::size_t axes) {
  for (Point& p : points)
    for (std::size_t k = 0; k < axes; ++k) p[k] = 0;
  return points;
}

TEST(Collapsed, AFrameThatWasNeverWrittenIsOneFact) {
  const std::vector<Point> zeros(sheet(0).size(), Point{0, 0, 0});
  const Report report =
      audit_of({sheet(0), zeros, sheet(0.1)}, Mesh(Index(zeros.size()), test::sheet_faces(kFineSquares)));
  EXPECT_FALSE(report.is_free());
  EXPECT_EQ(report.first_bad(), 1u);
  EXPECT_EQ(report.collapsed, 1u);
  EXPECT_TRUE(report.frames[1].has_collapsed);
  EXPECT_NE(report.frames[1].note.find("all vertices lie at one point"), std::string::npos) << report.frames[1].note;
  EXPECT_TRUE(report.pairs.empty());
  EXPECT_FALSE(report.frames[1].has_step);
  EXPECT_FALSE(report.frames[2].has_step) << "it would begin where all parts touch";
  EXPECT_TRUE(report.frames[2].is_free());
}

TEST(Collapsed, OneObjectOfTwoLeavesTheOtherToBeAsked) {
  std::vector<Face> faces = test::sheet_faces(kFineSquares);
  const auto count = static_cast<Index>(sheet(0).size());
  for (const Face& face : test::sheet_faces(kFineSquares, count)) faces.push_back(face);
  faces.push_back({2 * count, 2 * count + 1, 2 * count + 2});
  const auto pose = [&](bool is_point, double needle) {
    std::vector<Point> all = sheet(0);
    for (const Point& p : sheet(1)) all.push_back(is_point ? Point{9, 9, 9} : p);
    for (const double x : {0.31, 0.36, 0.33}) all.push_back({x, x + 0.01 * (x == 0.33), needle});
    return all;
  };
  const Report report = audit_of({pose(false, 0.5), pose(true, -0.5)}, Mesh(2 * count + 3, faces));
  EXPECT_TRUE(report.frames[1].has_collapsed);
  EXPECT_NE(report.frames[1].note.find("object with vertex " + std::to_string(count)), std::string::npos);
  EXPECT_TRUE(report.frames[1].has_step);
  EXPECT_GT(report.frames[1].contacts(), 0u) << "the triangle falls through the sheet that is left";
  EXPECT_LT(report.frames[1].contacts(), 1000u);
  EXPECT_EQ(report.frames[1].toi_lower, 0) << "nothing is proven of what is left out";
}

TEST(Collapsed, OnALineButNotInAPlane) {
  const Mesh mesh(Index(sheet(0).size()), test::sheet_faces(kFineSquares));
  const auto says = [&](std::size_t axes) {
    const std::vector<Point> pose = squeezed(sheet(0), axes);
    return collapsed_in(mesh, components_of(mesh), pose).sentence;
  };
  EXPECT_EQ(says(0), "");
  EXPECT_EQ(says(1), "");
  EXPECT_EQ(says(2), "all vertices lie on one line");
  EXPECT_EQ(says(3), "all vertices lie at one point");
}

// Bug: triangles that share corners alone, one behind the other on a line, are said to touch.
TEST(Collapsed, TrianglesBehindEachOtherOnALineAreAskedAbout) {
  std::vector<Face> faces;
  std::vector<Point> points{{0, 0, 0}};
  for (Index i = 0; i < 12; i += 2) {
    faces.push_back({i, i + 1, i + 2});
    for (const double x : {0.5, 1.0}) points.push_back({0.5 * i + x, 0, 0});
  }
  const Mesh mesh(Index(points.size()), faces);
  EXPECT_FALSE(collapsed_in(mesh, components_of(mesh), points).any());
  EXPECT_TRUE(audit_of({points, points}, mesh).is_free());
}

// Bug: a rod along an axis, or a triangle that is a point, is taken for a fault.
TEST(Collapsed, RodsAndSmallTrianglesAreNone) {
  std::vector<Edge> rod;
  for (Index i = 0; i < 20; ++i) rod.push_back({i, i + 1});
  const Mesh mesh(24, {{21, 22, 23}}, rod);
  std::vector<Point> points;
  for (int i = 0; i < 24; ++i) points.push_back({i < 21 ? double(i) : 50, 0, 0});
  EXPECT_FALSE(collapsed_in(mesh, components_of(mesh), points).any());
}

}  // namespace
}  // namespace tamis::audit
