// A caller's own memory as positions: each layout must give the answer of a plain vector of points.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <limits>
#include <tamis/tamis.hpp>
#include <type_traits>

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

// Taken for rows, columns would be a mesh torn to pieces, silently.
static_assert(!std::is_constructible_v<tamis::Positions, Eigen::Matrix<double, Eigen::Dynamic, 3>>);
static_assert(!std::is_constructible_v<tamis::Positions, Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor>>);

TEST(Positions, that_are_no_rows_of_three_doubles_are_refused) {
  tamis::Detector detector(tamis::Mesh(6, {{0, 1, 2}, {3, 4, 5}}));
  const RowMajorAnyWidth good = padded(kStart, 3), wide = padded(kStart, 4);
  EXPECT_THROW(detector.contacts({good, wide}), tamis::InvalidStep);
  EXPECT_THROW(detector.contacts({good, good.topRows(5)}), tamis::InvalidStep);

  // Every second double of a row: the inner stride is 2, which a view of rows cannot follow.
  const RowMajorAnyWidth spread = RowMajorAnyWidth::Zero(6, 6);
  const Eigen::Map<const RowMajor, 0, Eigen::Stride<Eigen::Dynamic, Eigen::Dynamic>> every_second(
      spread.data(), 6, 3, Eigen::Stride<Eigen::Dynamic, Eigen::Dynamic>(6, 2));
  EXPECT_THROW(detector.contacts({good, every_second}), tamis::InvalidStep);
}

}  // namespace
