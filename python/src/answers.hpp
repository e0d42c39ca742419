// Small answers as tuples; the Python side gives their parts names.
#pragma once
#include <array>
#include <vector>

#include "python/src/arrays.hpp"
#include "tamis/world.hpp"

namespace tamis::python {

inline nb::tuple as_tuple(const std::array<Index, 4>& v) { return nb::make_tuple(v[0], v[1], v[2], v[3]); }

inline nb::tuple as_tuple(const LimitingPair& pair) {
  return nb::make_tuple(static_cast<int>(pair.kind), as_tuple(pair.vertices), pair.distance);
}

inline nb::tuple as_tuple(const BodyStep::Pair& pair) {
  const LimitingPair& features = pair;
  return nb::make_tuple(pair.bodies[0], pair.bodies[1], as_tuple(features));
}

/// Of an EarliestContact, or one of bodies.
template <class Earliest>
nb::tuple earliest_tuple(const Earliest& first) {
  std::vector<typename decltype(first.contact)::value_type> contact;
  if (first.contact) contact.push_back(*first.contact);
  return nb::make_tuple(first.toi_lower, first.toi_upper, own_bytes(std::move(contact)));
}

/// Both times of each, then which have a contact, and those.
inline nb::tuple earliest_columns(const std::vector<EarliestBodyContact>& each) {
  std::vector<double> lower, upper;
  std::vector<Index> touching;
  std::vector<BodyContact> contacts;
  for (const EarliestBodyContact& first : each) {
    if (first.contact) {
      touching.push_back(static_cast<Index>(lower.size()));
      contacts.push_back(*first.contact);
    }
    lower.push_back(first.toi_lower);
    upper.push_back(first.toi_upper);
  }
  return nb::make_tuple(own<double>(std::move(lower)), own<double>(std::move(upper)), own<Index>(std::move(touching)),
                        own_bytes(std::move(contacts)));
}

/// Of a SafeStep, or one of bodies.
template <class Step>
nb::tuple step_tuple(const Step& safe) {
  const nb::object pair = safe.pair ? nb::object(as_tuple(*safe.pair)) : nb::none();
  return nb::make_tuple(safe.lower, safe.upper, pair);
}

}  // namespace tamis::python
