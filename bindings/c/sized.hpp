// Reads and writes the caller's structs, which may be older or newer than the library's, and arrays.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

#include "c/failure.hpp"
#include "tamis/step.hpp"

namespace tamis::c {

/// No struct grows beyond this; a larger size was never set.
inline constexpr std::size_t kMostBytes = 1U << 16U;

[[noreturn]] inline void refuse_size(std::size_t size, const char* name) {
  throw InvalidArgument(std::string(name) + " has the size " + std::to_string(size) + ": set it to sizeof");
}
inline void check_size(std::size_t size, std::size_t least, const char* name) {
  if (size < least || size > kMostBytes) refuse_size(size, name);
}

/// No address space has so many rows. Four times as many still fit into std::size_t.
inline constexpr int kCountBits = sizeof(std::size_t) > 4 ? 48 : 29;

/// Refuses a count beyond any address space before a row is read: it is a negative number, or was never set.
inline void check_count(std::size_t count, const char* name) {
  if (count >> kCountBits != 0)
    throw InvalidArgument(std::string(name) + " is " + std::to_string(count) + ": give a number of rows below 2^" +
                          std::to_string(kCountBits));
}

/// count * of_each. Refuses more rows than any array has.
inline std::size_t product(std::size_t count, std::size_t of_each, const char* name) {
  check_count(of_each, name);
  constexpr std::size_t kMost = std::size_t{1} << kCountBits;
  if (of_each > 0) check_count(count > kMost / of_each ? ~std::size_t{0} : count * of_each, name);
  return count * of_each;
}

/// The size that a caller's struct says. Every sizeof is a multiple of the alignment; another number was never set, and
/// might end in the middle of a pointer.
template <class T>
std::size_t size_said(const T* given, const char* name) {
  static_assert(std::is_trivially_copyable_v<T> && offsetof(T, size) == 0);
  std::size_t size = 0;
  std::memcpy(&size, &required(given, name), sizeof(size));
  check_size(size, sizeof(size), name);
  if (size % alignof(T) != 0) refuse_size(size, name);
  return size;
}

/// The library's fields of a caller's struct; fields that the caller does not know are zero.
template <class T>
T read_sized(const T* given, const char* name) {
  const std::size_t size = size_said(given, name);
  const auto* bytes = reinterpret_cast<const unsigned char*>(given);
  if (size > sizeof(T) && std::any_of(bytes + sizeof(T), bytes + size, [](unsigned char b) { return b != 0; }))
    throw InvalidArgument(std::string(name) + " sets a field that version " + tamis_version() +
                          " does not know: set it to zero, or use a newer library");
  T known{};
  std::memcpy(&known, given, std::min(size, sizeof(T)));
  return known;
}

/// Options that a caller may leave out.
template <class T>
T read_options(const T* given) {
  return given ? read_sized(given, "options") : T{};
}

/// Writes the fields of an answer for which the caller's struct has room.
template <class T>
void write_sized(T answer, T* to, const char* name) {
  const std::size_t size = size_said(to, name);
  answer.size = size;
  std::memcpy(to, &answer, std::min(size, sizeof(T)));
}

/// Writes element `i` of a caller's array whose elements may be shorter or longer than the library's; longer ones end
/// in zeros.
template <class T>
void write_element(const T& element, void* array, std::size_t i, std::size_t element_size) {
  unsigned char* to = static_cast<unsigned char*>(array) + i * element_size;
  std::memcpy(to, &element, std::min(element_size, sizeof(T)));
  if (element_size > sizeof(T)) std::memset(to + sizeof(T), 0, element_size - sizeof(T));
}

/// Copies points as rows of three doubles.
inline void copy_points(const std::vector<Point>& points, double* to) {
  for (const Point& p : points) to = std::copy(p.begin(), p.end(), to);
}

}  // namespace tamis::c
