// Small answers as tuples; the Python side gives their parts names.
#pragma once
#include <array>
#include <vector>

#include "python/src/arrays.hpp"
#include "tamis/contact.hpp"

namespace tamis::python {

inline nb::tuple as_tuple(const std::array<Index, 4>& v) { return nb::make_tuple(v[0], v[1], v[2], v[3]); }

inline nb::tuple as_tuple(const EarliestContact& first) {
  std::vector<Contact> contact;
  if (first.contact) contact.push_back(*first.contact);
  return nb::make_tuple(first.toi_lower, first.toi_upper, own_bytes(std::move(contact)));
}

inline nb::tuple as_tuple(const SafeStep& safe) {
  if (!safe.pair) return nb::make_tuple(safe.lower, safe.upper, nb::none());
  const LimitingPair& pair = *safe.pair;
  return nb::make_tuple(safe.lower, safe.upper,
                        nb::make_tuple(static_cast<int>(pair.kind), as_tuple(pair.vertices), pair.distance));
}

}  // namespace tamis::python
