// NumPy arrays as the library's views, and the library's vectors as NumPy arrays that own them.
#pragma once
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <initializer_list>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "tamis/step.hpp"

namespace tamis::python {

namespace nb = nanobind;

/// n x 3 doubles, a row's three together; rows may lie apart. The Python side hands over nothing else.
using Rows = nb::ndarray<const double, nb::shape<-1, 3>, nb::device::cpu>;
using PointRows = nb::ndarray<const double, nb::shape<-1, 3>, nb::c_contig, nb::device::cpu>;
template <int columns>
using IndexRowsIn = nb::ndarray<const Index, nb::shape<-1, columns>, nb::c_contig, nb::device::cpu>;
using Indices = nb::ndarray<const Index, nb::shape<-1>, nb::c_contig, nb::device::cpu>;

/// The stride of one row alone may be anything.
inline Positions positions(const Rows& rows) {
  const auto count = static_cast<Index>(rows.shape(0));
  return {rows.data(), count, count > 1 ? static_cast<std::ptrdiff_t>(rows.stride(0)) : 3};
}
inline Step step_of(const Rows& start, const Rows& end) { return {positions(start), positions(end)}; }

inline std::vector<Point> points_of(const Positions& positions) {
  std::vector<Point> points;
  points.reserve(static_cast<std::size_t>(positions.count()));
  for (Index v = 0; v < positions.count(); ++v) points.push_back({positions[v][0], positions[v][1], positions[v][2]});
  return points;
}

/// An array over a vector that is moved into it.
template <class Number, class Element>
nb::object own_in_shape(std::vector<Element>&& vector, std::initializer_list<std::size_t> shape) {
  static_assert(std::is_trivially_copyable_v<Element>);
  auto holder = std::make_unique<std::vector<Element>>(std::move(vector));
  auto* data = reinterpret_cast<Number*>(holder->data());
  const nb::capsule owner(holder.get(), [](void* p) noexcept { delete static_cast<std::vector<Element>*>(p); });
  holder.release();
  return nb::ndarray<nb::numpy, Number>(data, shape, owner).cast();
}

/// A row of numbers an element; one dimension where an element is one number.
template <class Number, class Element>
nb::object own(std::vector<Element>&& vector) {
  constexpr std::size_t columns = sizeof(Element) / sizeof(Number);
  static_assert(sizeof(Element) == columns * sizeof(Number));
  const std::size_t rows = vector.size();
  if constexpr (columns == 1)
    return own_in_shape<Number>(std::move(vector), {rows});
  else
    return own_in_shape<Number>(std::move(vector), {rows, columns});
}

/// The bytes of a vector of records; the Python side knows their layout.
template <class Record>
nb::object own_bytes(std::vector<Record>&& records) {
  const std::size_t bytes = records.size() * sizeof(Record);
  return own_in_shape<std::uint8_t>(std::move(records), {bytes});
}

/// A list of a detector dies at its next question, which another thread may ask.
template <class Row>
std::vector<Row> copied(std::span<const Row> rows) {
  return {rows.begin(), rows.end()};
}

template <class Element, class Array>
std::vector<Element> copy_of(const Array& array) {
  static_assert(sizeof(Element) % sizeof(Index) == 0);
  const auto* first = reinterpret_cast<const Element*>(array.data());
  return {first, first + array.shape(0)};
}

}  // namespace tamis::python
