// Positions of all vertices: a view of the caller's own memory.
#pragma once
#include <array>
#include <concepts>
#include <cstddef>
#include <limits>
#include <ranges>
#include <span>
#include <type_traits>
#include <utility>

#include "tamis/mesh.hpp"

namespace tamis {

using Point = std::array<double, 3>;  ///< three coordinates

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
/// A matrix that is not a view: its memory goes with it.
template <class M>
concept OwningMatrix = DenseMatrix<M> && requires {
  requires std::same_as<M, typename M::PlainObject>;
};

/// A type that says itself that it has three elements: an array, or one of Eigen's fixed vectors.
template <class V>
concept CountsThree = std::extent_v<V>
== 3 || requires { requires std::tuple_size<V>::value == 3; }
|| requires { requires int(V::SizeAtCompileTime) == 3; };
/// Three doubles that have an index: v[0], v[1], v[2].
template <class V>
concept IndexedDoubles = CountsThree<V> && requires(const V& v) {
  { v[0] } -> std::same_as<const double&>;
};
/// Doubles x, y and z, in this order in memory.
template <class V>
concept DoublesXyz = std::is_standard_layout_v<V> && requires(const V& v) {
  { (v.x) } -> std::same_as<const double&>;
  { (v.y) } -> std::same_as<const double&>;
  { (v.z) } -> std::same_as<const double&>;
  requires offsetof(V, x)
  < offsetof(V, y) && offsetof(V, y) < offsetof(V, z);
};
/// Three doubles next to each other and nothing else: std::array<double, 3>, double[3], Eigen::Vector3d, glm::dvec3, or
/// a struct of x, y and z.
template <class V>
concept ThreeDoubles = sizeof(V) == 3 * sizeof(double) && (IndexedDoubles<V> || DoublesXyz<V>);

/// Elements one behind the other in memory, as in a std::vector, std::array or std::span.
template <class R>
concept ContiguousRange = !MatrixLike<R> && requires(const R& r) {
  std::span(r);
};
/// The type of a range's elements.
template <ContiguousRange R>
using ElementOf = typename decltype(std::span(std::declval<const R&>()))::value_type;
/// A contiguous range of points of three doubles.
template <class R>
concept PointRange = ContiguousRange<R> && ThreeDoubles<ElementOf<R>>;
/// A range that is not a view.
template <class R>
concept OwningRange = PointRange<R> && !std::ranges::enable_borrowed_range<R> && !std::ranges::enable_view<R>;

/// A read-only view of n x 3 doubles; the caller keeps the memory alive.
class Positions {
 public:
  Positions() = default;
  /// Views `count` vertices. `stride`: distance in doubles from one vertex to the next, >= 3.
  Positions(const double* data, Index count, std::ptrdiff_t stride = 3) : data_(data), count_(count), stride_(stride) {}
  /// Views a range: one vertex an element.
  template <PointRange R>
  Positions(const R& points)
      : Positions(reinterpret_cast<const double*>(std::span(points).data()), index_count(std::span(points).size())) {}
  /// Views a matrix of one vertex a row. Unless it has three columns next to each other, the view has no data. Then
  /// every question refuses it.
  template <RowMajorMatrix M>
  Positions(const M& matrix)
      : Positions(matrix.cols() == 3 && matrix.innerStride() == 1 ? matrix.data() : nullptr,
                  index_count(static_cast<std::size_t>(matrix.rows())),
                  static_cast<std::ptrdiff_t>(matrix.outerStride())) {}
  /// Views a matrix of one vertex a column. Unless the numbers of a column are next to each other, it has no data.
  template <ThreeRowMatrix M>
  Positions(const M& matrix)
      : Positions(matrix.innerStride() == 1 ? matrix.data() : nullptr,
                  index_count(static_cast<std::size_t>(matrix.cols())),
                  static_cast<std::ptrdiff_t>(matrix.outerStride())) {}

  // Compilers show the line of the deleted constructor: its comment says what to do.
  template <OwningRange R>
  Positions(const R&&) = delete;  // A temporary may be gone when the question is asked: keep it in a variable.
  template <OwningMatrix M>
  Positions(const M&&) = delete;  // A temporary may be gone when the question is asked: keep it in a variable.
  // The sentence must stand in the line that compilers show.
  // clang-format off
  template <MatrixLike M>
  requires(DenseMatrix<M> && !RowMajorMatrix<M> && !ThreeRowMatrix<M>)
  Positions(const M&) = delete;  // Column-major? Keep tamis::points_of(x). Flat x y z? Positions(x.data(), vertices).
  template <MatrixLike M>
  requires(!DenseMatrix<M>)
  Positions(const M&) = delete;  // Floats, or an expression without memory? tamis::points_of(x) copies it as doubles.
  template <ContiguousRange R>
  requires(!PointRange<R>)
  Positions(const R&) = delete;  // Floats? tamis::points_of(x). Flat doubles, x y z x y z? Positions(data, vertices).
  // clang-format on

  /// Returns the three coordinates of a vertex.
  const double* operator[](Index vertex) const { return data_ + vertex * stride_; }
  /// Returns the first coordinate of the first vertex.
  const double* data() const { return data_; }
  /// Returns the number of vertices; -1 if it does not fit into Index.
  Index count() const { return count_; }
  /// Returns the distance in doubles from one vertex to the next.
  std::ptrdiff_t stride() const { return stride_; }

 private:
  /// Returns the count, or -1 if it does not fit into Index. No mesh has -1 vertices, so every question refuses it.
  static constexpr Index index_count(std::size_t count) {
    return count <= static_cast<std::size_t>(std::numeric_limits<Index>::max()) ? static_cast<Index>(count) : -1;
  }

  const double* data_ = nullptr;
  Index count_ = 0;
  std::ptrdiff_t stride_ = 3;
};

}  // namespace tamis
