// Configurations of a linkage as they lie in NumPy, and answers about edges between them.
#pragma once
#include <algorithm>
#include <span>
#include <vector>

#include "python/src/answers.hpp"
#include "tamis/linkage.hpp"

namespace tamis::python {

/// A configuration a row.
using ConfigurationRows = nb::ndarray<const double, nb::shape<-1, -1>, nb::c_contig, nb::device::cpu>;
using Numbers = nb::ndarray<const double, nb::shape<-1>, nb::c_contig, nb::device::cpu>;

inline std::span<const double> numbers_of(const ConfigurationRows& rows) {
  return {rows.data(), rows.shape(0) * rows.shape(1)};
}

inline nb::object flags_of(const std::vector<bool>& flags) {
  return own<std::uint8_t>(std::vector<std::uint8_t>(flags.begin(), flags.end()));
}

/// The columns of answers about edges: fractions and their upper bounds, overlaps at the start, bodies, points. Then
/// which have a contact, and those.
inline nb::tuple edge_columns(const std::vector<EdgeAnswer>& answers) {
  std::vector<double> lower, upper;
  std::vector<std::uint8_t> overlaps;
  std::vector<std::array<Index, 2>> bodies;
  std::vector<Point> points;
  std::vector<Index> touching;
  std::vector<BodyContact> contacts;
  for (const EdgeAnswer& answer : answers) {
    if (answer.contact) {
      touching.push_back(static_cast<Index>(lower.size()));
      contacts.push_back(*answer.contact);
    }
    lower.push_back(answer.fraction);
    upper.push_back(answer.fraction_upper);
    overlaps.push_back(answer.overlaps_at_start);
    bodies.push_back(answer.bodies);
    points.push_back(answer.point);
  }
  return nb::make_tuple(own<double>(std::move(lower)), own<double>(std::move(upper)),
                        own<std::uint8_t>(std::move(overlaps)), own<Index>(std::move(bodies)),
                        own<double>(std::move(points)), own<Index>(std::move(touching)),
                        own_bytes(std::move(contacts)));
}

}  // namespace tamis::python
