// Where every vertex is at the start and at the end of a time step: two views, nothing is copied.
#pragma once
#include <array>
#include <concepts>
#include <cstddef>
#include <limits>
#include <span>

#include "tamis/mesh.hpp"

namespace tamis {

using Point = std::array<double, 3>;

/// An Eigen-like dense matrix of doubles. Eigen itself is not needed.
template <class M>
concept DenseMatrix = requires(const M& m) {
  { m.data() } -> std::convertible_to<const double*>;
  { m.rows() } -> std::convertible_to<std::ptrdiff_t>;
  { m.cols() } -> std::convertible_to<std::ptrdiff_t>;
  { m.outerStride() } -> std::convertible_to<std::ptrdiff_t>;
  { m.innerStride() } -> std::convertible_to<std::ptrdiff_t>;
  { M::IsRowMajor } -> std::convertible_to<bool>;
};
/// One vertex a row, row by row: three columns.
template <class M>
concept RowMajorMatrix = DenseMatrix<M> && bool(M::IsRowMajor);
/// One vertex a column, column by column: three rows, known to the compiler (Eigen's Matrix3Xd).
template <class M>
concept ThreeRowMatrix = DenseMatrix<M> && !bool(M::IsRowMajor) && M::RowsAtCompileTime == 3;

/// A read-only view of n x 3 doubles; the caller keeps the memory alive.
class Positions {
 public:
  Positions() = default;
  /// `stride`: distance in doubles from one vertex to the next, >= 3.
  Positions(const double* data, Index count, std::ptrdiff_t stride = 3) : data_(data), count_(count), stride_(stride) {}
  Positions(std::span<const Point> points)
      : Positions(points.empty() ? nullptr : points.front().data(), index_count(points.size())) {}
  Positions(const std::vector<Point>& points) : Positions(std::span<const Point>(points)) {}
  /// Other than three columns next to each other: no data, which every question refuses.
  template <RowMajorMatrix M>
  Positions(const M& matrix)
      : Positions(matrix.cols() == 3 && matrix.innerStride() == 1 ? matrix.data() : nullptr,
                  index_count(static_cast<std::size_t>(matrix.rows())),
                  static_cast<std::ptrdiff_t>(matrix.outerStride())) {}
  template <ThreeRowMatrix M>
  Positions(const M& matrix)
      : Positions(matrix.innerStride() == 1 ? matrix.data() : nullptr,
                  index_count(static_cast<std::size_t>(matrix.cols())),
                  static_cast<std::ptrdiff_t>(matrix.outerStride())) {}
  /// Column by column no vertex has its three numbers side by side, and taken for rows they would be another mesh.
  template <DenseMatrix M>
  Positions(const M&) = delete;  // Column-major? Use a RowMajor matrix, a Matrix3Xd, or tamis::points_of(matrix).

  const double* operator[](Index vertex) const { return data_ + vertex * stride_; }
  const double* data() const { return data_; }
  Index count() const { return count_; }
  std::ptrdiff_t stride() const { return stride_; }

 private:
  /// -1, which no mesh has and every question refuses, for more than an Index counts.
  static constexpr Index index_count(std::size_t count) {
    return count <= static_cast<std::size_t>(std::numeric_limits<Index>::max()) ? static_cast<Index>(count) : -1;
  }

  const double* data_ = nullptr;
  Index count_ = 0;
  std::ptrdiff_t stride_ = 3;
};

/// One time step: each vertex moves on a straight line from `start` (t=0) to `end` (t=1).
struct Step {
  Positions start;
  Positions end;
};

}  // namespace tamis
