// Small answers as tuples; the Python side gives their parts names.
#pragma once
#include <optional>
#include <vector>

#include "python/src/arrays.hpp"
#include "tamis/world.hpp"

namespace tamis::python {

/// None or one, as rows.
template <class Answer>
nb::object rows_of(const std::optional<Answer>& answer) {
  std::vector<Answer> rows;
  if (answer) rows.push_back(*answer);
  return own_bytes(std::move(rows));
}

/// Of an EarliestContact, or one of bodies.
template <class Earliest>
nb::tuple earliest_tuple(const Earliest& first) {
  return nb::make_tuple(first.toi_lower, first.toi_upper, rows_of(first.contact));
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
  return nb::make_tuple(safe.toi_lower, safe.toi_upper, rows_of(safe.pair));
}

}  // namespace tamis::python
