// NumPy arrays as the library's views, and the library's vectors as NumPy arrays that own them.
#pragma once
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "tamis/step.hpp"

namespace tamis::python {

namespace nb = nanobind;

/// n x 3 doubles, a row's three together; rows may lie apart. The Python side hands over nothing else.
using Rows = nb::ndarray<const double, nb::shape<-1, 3>, nb::device::cpu>;
template <int columns>
using IndexRowsIn = nb::ndarray<const Index, nb::shape<-1, columns>, nb::c_contig, nb::device::cpu>;
using Indices = nb::ndarray<const Index, nb::shape<-1>, nb::c_contig, nb::device::cpu>;

inline Positions positions(const Rows& rows) {
  return {rows.data(), static_cast<Index>(rows.shape(0)), static_cast<std::ptrdiff_t>(rows.stride(0))};
}

/// An array over a vector that is moved into it; `columns` numbers a row, or 0 for one dimension.
template <class Number, class Element>
nb::object own(std::vector<Element>&& vector, std::size_t columns) {
  static_assert(std::is_trivially_copyable_v<Element> && sizeof(Element) % sizeof(Number) == 0);
  auto holder = std::make_unique<std::vector<Element>>(std::move(vector));
  const std::size_t rows = holder->size();
  auto* data = reinterpret_cast<Number*>(holder->data());
  const nb::capsule owner(holder.get(), [](void* p) noexcept { delete static_cast<std::vector<Element>*>(p); });
  holder.release();
  const std::size_t shape[] = {rows, columns};
  return nb::ndarray<nb::numpy, Number>(data, columns > 0 ? 2 : 1, shape, owner).cast();
}

/// The bytes of a vector of records; the Python side knows their layout.
template <class Record>
nb::object own_bytes(std::vector<Record>&& records) {
  const std::size_t bytes = records.size() * sizeof(Record);
  auto holder = std::make_unique<std::vector<Record>>(std::move(records));
  auto* data = reinterpret_cast<std::uint8_t*>(holder->data());
  const nb::capsule owner(holder.get(), [](void* p) noexcept { delete static_cast<std::vector<Record>*>(p); });
  holder.release();
  return nb::ndarray<nb::numpy, std::uint8_t>(data, {bytes}, owner).cast();
}

template <class Element, class Array>
std::vector<Element> copy_of(const Array& array) {
  static_assert(sizeof(Element) % sizeof(Index) == 0);
  const auto* first = reinterpret_cast<const Element*>(array.data());
  return {first, first + array.shape(0)};
}

}  // namespace tamis::python
