// A caller's own memory as positions: each layout must give the answer of a plain vector of points.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <limits>
#include <tamis/tamis.hpp>

namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
using RowMajorAnyWidth = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

const std::vector<tamis::Point> kStart{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.25, 0.25, 1}, {1, 0.5, 2}, {0.5, 1, 2}};
const std::vector<tamis::Point> kEnd{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.25, 0.25, -1}, {1, 0.5, 2}, {0.5, 1, 2}};

/// The rows of `points` in the first three of `width` columns. The others hold NaN: reading one of them shows.
RowMajorAnyWidth padded(const std::vector<tamis::Point>& points, Eigen::Index width) {
  RowMajorAnyWidth matrix = RowMajorAnyWidth::Constant(static_cast<Eigen::Index>(points.size()), width, kNaN);
  for (Eigen::Index row = 0; row < matrix.rows(); ++row)
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      matrix(row, axis) = points[static_cast<std::size_t>(row)][static_cast<std::size_t>(axis)];
  return matrix;
}

void expect_the_one_contact(const tamis::Step& step) {
  tamis::Detector detector(tamis::Mesh(6, {{0, 1, 2}, {3, 4, 5}}));
  const auto& contacts = detector.contacts(step);
  ASSERT_EQ(contacts.size(), 1u);
  EXPECT_EQ(contacts[0].vertices, (std::array<tamis::Index, 4>{3, 0, 1, 2}));
  EXPECT_LE(contacts[0].toi_lower, 0.5);
  EXPECT_GE(contacts[0].toi_upper, 0.5);
}

TEST(Positions, of_a_vector_of_points) { expect_the_one_contact({kStart, kEnd}); }

TEST(Positions, of_an_eigen_matrix_of_three_columns) {
  const RowMajor start = padded(kStart, 3), end = padded(kEnd, 3);
  expect_the_one_contact({start, end});
}

TEST(Positions, of_columns_of_a_wider_eigen_matrix_skip_the_rest_of_each_row) {
  const RowMajorAnyWidth start = padded(kStart, 7), end = padded(kEnd, 4);
  expect_the_one_contact({start.leftCols(3), end.leftCols(3)});
}

TEST(Positions, of_a_map_with_outer_stride) {
  const RowMajorAnyWidth start = padded(kStart, 5), end = padded(kEnd, 5);
  using Map = Eigen::Map<const RowMajor, 0, Eigen::OuterStride<>>;
  expect_the_one_contact(
      {Map(start.data(), 6, 3, Eigen::OuterStride<>(5)), Map(end.data(), 6, 3, Eigen::OuterStride<>(5))});
}

TEST(Positions, of_a_raw_pointer_with_stride) {
  const RowMajorAnyWidth start = padded(kStart, 4), end = padded(kEnd, 9);
  expect_the_one_contact({tamis::Positions(start.data(), 6, 4), tamis::Positions(end.data(), 6, 9)});
}

TEST(Positions, of_anything_that_holds_three_doubles_a_vertex) {
  struct Xyz {
    double x, y, z;
  };
  std::vector<Eigen::Vector3d> vectors;
  std::vector<Xyz> structs;
  double arrays[6][3];
  for (std::size_t v = 0; v < kStart.size(); ++v) {
    vectors.emplace_back(kStart[v].data());
    structs.push_back({kEnd[v][0], kEnd[v][1], kEnd[v][2]});
    std::copy(kEnd[v].begin(), kEnd[v].end(), arrays[v]);
  }
  expect_the_one_contact({vectors, structs});
  expect_the_one_contact({std::span<const Eigen::Vector3d>(vectors), arrays});
}

TEST(Positions, of_floats_are_copied_by_points_of) {
  std::vector<Eigen::Vector3f> floats;
  for (const tamis::Point& p : kStart) floats.emplace_back(Eigen::Vector3d(p.data()).cast<float>());
  const auto copies = tamis::points_of(floats);
  expect_the_one_contact({copies, kEnd});
}

TEST(Positions, of_a_matrix_of_three_rows_are_its_columns) {
  const Eigen::Matrix3Xd start = padded(kStart, 3).transpose();
  const Eigen::Matrix<double, 5, Eigen::Dynamic> wide = padded(kEnd, 5).transpose();
  expect_the_one_contact({start, wide.topRows<3>()});
}

TEST(Positions, of_columns_side_by_side_are_copied_by_points_of) {
  const Eigen::MatrixXd start = padded(kStart, 3);
  const Eigen::Matrix<double, Eigen::Dynamic, 3> end = padded(kEnd, 3);
  const auto starts = tamis::points_of(start), ends = tamis::points_of(end);
  expect_the_one_contact({starts, ends});
  EXPECT_THROW(tamis::points_of(start.leftCols(2)), tamis::InvalidStep);
}

TEST(Topology, comes_from_pointers_and_from_integer_matrices_of_either_layout) {
  Eigen::MatrixXi faces(2, 3);
  faces << 0, 1, 2, 3, 4, 5;
  const std::vector<tamis::Face> expected{{0, 1, 2}, {3, 4, 5}};
  EXPECT_EQ(tamis::faces_of(faces), expected);
  const Eigen::Matrix<std::int64_t, Eigen::Dynamic, 3, Eigen::RowMajor> wide = faces.cast<std::int64_t>();
  EXPECT_EQ(tamis::faces_of(wide), expected);
  const int rows[] = {0, 1, 2, -9, 3, 4, 5, -9};
  EXPECT_EQ(tamis::faces_of(rows, 2, 4), expected);
  EXPECT_EQ(tamis::edges_of(faces.leftCols(2)), (std::vector<tamis::Edge>{{0, 1}, {3, 4}}));
  EXPECT_EQ(tamis::edges_of(rows, 1), (std::vector<tamis::Edge>{{0, 1}}));
  EXPECT_EQ(tamis::Mesh(6, tamis::faces_of(faces)).edges().size(), 6u);
}

TEST(Topology, that_does_not_fit_is_refused) {
  EXPECT_THROW(tamis::faces_of(Eigen::MatrixXi::Zero(3, 4)), tamis::InvalidMesh);
  EXPECT_THROW(tamis::edges_of(Eigen::MatrixXi::Zero(4, 3)), tamis::InvalidMesh);
  Eigen::Matrix<std::int64_t, 1, 3> face;
  face << 0, 1, (std::int64_t{1} << 32) + 2;  // cut to 32 bits it would be vertex 2
  EXPECT_THROW(tamis::Mesh(6, tamis::faces_of(face)), tamis::InvalidMesh);
}

TEST(Positions, that_are_no_rows_of_three_doubles_are_refused) {
  tamis::Detector detector(tamis::Mesh(6, {{0, 1, 2}, {3, 4, 5}}));
  const RowMajorAnyWidth good = padded(kStart, 3), wide = padded(kStart, 4);
  EXPECT_THROW((void)detector.contacts({good, wide}), tamis::InvalidStep);
  EXPECT_THROW((void)detector.contacts({good, good.topRows(5)}), tamis::InvalidStep);

  // Every second double of a row: the inner stride is 2, which a view of rows cannot follow.
  const RowMajorAnyWidth spread = RowMajorAnyWidth::Zero(6, 6);
  const Eigen::Map<const RowMajor, 0, Eigen::Stride<Eigen::Dynamic, Eigen::Dynamic>> every_second(
      spread.data(), 6, 3, Eigen::Stride<Eigen::Dynamic, Eigen::Dynamic>(6, 2));
  EXPECT_THROW((void)detector.contacts({good, every_second}), tamis::InvalidStep);
}

}  // namespace
