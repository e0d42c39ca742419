// Copies topology and positions from the caller's own layout. It may be raw pointers, or vectors of points of any
// number type. It may be a matrix stored by rows or by columns: Eigen's, or any type with rows(), cols() and an element
// (row, column).
#pragma once
#include <concepts>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "tamis/error.hpp"
#include "tamis/mesh.hpp"
#include "tamis/step.hpp"

namespace tamis {

/// A matrix of any numbers: rows(), cols() and an element (row, column).
template <class M>
concept AnyMatrix = requires(const M& m, std::ptrdiff_t i) {
  { m.rows() } -> std::convertible_to<std::ptrdiff_t>;
  { m.cols() } -> std::convertible_to<std::ptrdiff_t>;
  m(i, i);
};
/// A matrix of integers of any size.
template <class M>
concept IndexMatrix = AnyMatrix<M> && requires(const M& m, std::ptrdiff_t i) {
  requires std::integral<std::remove_cvref_t<decltype(m(i, i))>>;
};

namespace from_matrix {

/// Requires a number of columns of a matrix. The message names its rows (`what`), and what takes flat numbers (`flat`).
/// Throws Error if the matrix has another number.
template <class Error, AnyMatrix M>
void require_columns(const M& matrix, std::ptrdiff_t columns, const char* what, const char* flat) {
  if (matrix.cols() != columns)
    throw Error("the matrix of " + std::string(what) + " has " + std::to_string(matrix.rows()) + " rows and " +
                std::to_string(matrix.cols()) + " columns: give a row of " + std::to_string(columns) +
                " for each (of a matrix with a column for each its transpose(); of flat numbers " + flat + ")");
}

/// Copies a matrix of one row a feature.
/// Returns the features. An index that does not fit into Index becomes -1, which Mesh refuses, naming the feature.
/// Throws InvalidMesh if the matrix has another number of columns than a feature has vertices.
template <class Feature, IndexMatrix M>
std::vector<Feature> rows_of(const M& matrix, const char* what, const char* flat) {
  std::vector<Feature> rows(static_cast<std::size_t>(matrix.rows()));
  require_columns<InvalidMesh>(matrix, std::tuple_size_v<Feature>, what, flat);
  for (std::size_t row = 0; row < rows.size(); ++row)
    for (std::size_t column = 0; column < rows[row].size(); ++column) {
      const auto index = matrix(static_cast<std::ptrdiff_t>(row), static_cast<std::ptrdiff_t>(column));
      rows[row][column] = std::in_range<Index>(index) ? static_cast<Index>(index) : -1;
    }
  return rows;
}

/// Copies `count` features. `stride`: number of indices from one feature's first to the next feature's first.
/// Returns the features.
template <class Feature>
std::vector<Feature> rows_of(const Index* indices, std::size_t count, std::ptrdiff_t stride) {
  std::vector<Feature> rows(count);
  for (std::size_t row = 0; row < count; ++row)
    for (std::size_t column = 0; column < rows[row].size(); ++column)
      rows[row][column] = indices[static_cast<std::ptrdiff_t>(row) * stride + static_cast<std::ptrdiff_t>(column)];
  return rows;
}

}  // namespace from_matrix

/// Copies the faces of a mesh from n x 3 indices. Mesh checks the indices.
/// Returns one face a row.
/// Throws InvalidMesh if the matrix has another number of columns.
template <IndexMatrix M>
std::vector<Face> faces_of(const M& matrix) {
  return from_matrix::rows_of<Face>(matrix, "faces", "faces_of(data, count)");
}
/// Copies the loose edges of a mesh from n x 2 indices; otherwise the same.
template <IndexMatrix M>
std::vector<Edge> edges_of(const M& matrix) {
  return from_matrix::rows_of<Edge>(matrix, "edges", "edges_of(data, count)");
}

/// Copies `count` triples of indices. `stride`: number of indices from one's first to the next one's first.
/// Returns the faces.
inline std::vector<Face> faces_of(const Index* indices, std::size_t count, std::ptrdiff_t stride = 3) {
  return from_matrix::rows_of<Face>(indices, count, stride);
}
/// Copies `count` pairs of indices; otherwise the same.
/// Returns the edges.
inline std::vector<Edge> edges_of(const Index* indices, std::size_t count, std::ptrdiff_t stride = 2) {
  return from_matrix::rows_of<Edge>(indices, count, stride);
}

/// Copies an n x 3 matrix of positions, in any layout.
/// Returns one point a row.
/// Throws InvalidStep if the matrix has another number of columns.
template <AnyMatrix M>
std::vector<Point> points_of(const M& matrix) {
  from_matrix::require_columns<InvalidStep>(matrix, 3, "positions", "Positions(data, vertices)");
  std::vector<Point> points(static_cast<std::size_t>(matrix.rows()));
  for (std::size_t row = 0; row < points.size(); ++row) {
    const auto r = static_cast<std::ptrdiff_t>(row);
    points[row] = {matrix(r, 0), matrix(r, 1), matrix(r, 2)};
  }
  return points;
}
/// Copies a range of points, such as Eigen::Vector3f or std::array<float, 3>.
/// Returns the points.
template <ContiguousRange R>
std::vector<Point> points_of(const R& points) {
  std::vector<Point> copies;
  for (const auto& p : points) copies.push_back({p[0], p[1], p[2]});
  return copies;
}

}  // namespace tamis
