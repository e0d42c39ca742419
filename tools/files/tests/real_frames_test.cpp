#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "files/mesh/mesh_file.hpp"
#include "support/test_data.hpp"

namespace tamis::io {
namespace {

/// Recorded scenes; they are no part of the project.
class RealData : public testing::Test {
 protected:
  void SetUp() override {
    if (data_.empty()) GTEST_SKIP() << test::kNoData;
  }
  std::filesystem::path data_ = test::data_folder();
};

// Bug: big-endian floats, or little-endian doubles, as other programs write them are misread.
TEST_F(RealData, FramesHaveTheSizesTheirAuthorsGive) {
  const MeshFile ball = read_mesh(data_ / "frames/cloth-ball/cloth_ball92.ply");
  EXPECT_EQ(ball.positions.size(), 46598u);
  EXPECT_EQ(ball.faces.size(), 92230u);
  const MeshFile funnel = read_mesh(data_ / "frames/cloth-funnel/227.ply");
  EXPECT_EQ(funnel.positions.size(), 9450u);
  EXPECT_EQ(funnel.faces.size(), 18484u);
  const MeshFile next = read_mesh(data_ / "frames/cloth-funnel/228.ply");
  EXPECT_NO_THROW(require_same_mesh(funnel, "227", next, "228"));
  double largest_move = 0;
  for (std::size_t v = 0; v < next.positions.size(); ++v)
    for (std::size_t axis = 0; axis < 3; ++axis)
      largest_move = std::max(largest_move, std::abs(next.positions[v][axis] - funnel.positions[v][axis]));
  EXPECT_GT(largest_move, 0);
  EXPECT_LT(largest_move, 0.1);
}

}  // namespace
}  // namespace tamis::io
