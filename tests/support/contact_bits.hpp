// Contacts as rows of numbers, for comparisons to the last bit.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "tamis/contact.hpp"

namespace tamis::test {

/// Every number of a contact.
inline std::array<double, 13> bits_of(const Contact& c) {
  return {double(c.kind),
          double(c.certainty),
          double(c.vertices[0]),
          double(c.vertices[1]),
          double(c.vertices[2]),
          double(c.vertices[3]),
          c.toi_lower,
          c.toi_upper,
          c.u,
          c.v,
          c.normal[0],
          c.normal[1],
          c.normal[2]};
}

inline std::vector<std::array<double, 13>> bits_of(std::span<const Contact> contacts) {
  std::vector<std::array<double, 13>> rows;
  for (const Contact& c : contacts) rows.push_back(bits_of(c));
  return rows;
}

}  // namespace tamis::test
