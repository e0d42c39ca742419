// Lists that outlive the next question of the detector that found them.
#pragma once
#include <span>
#include <vector>

#include "tamis/detector.hpp"

namespace tamis::test {

template <class Row>
std::vector<Row> copied(std::span<const Row> rows) {
  return {rows.begin(), rows.end()};
}

/// The answers of a detector that lives for one question.
inline std::vector<Contact> contacts_of(Detector detector, const Step& step) { return copied(detector.contacts(step)); }
inline std::vector<NearPair> pairs_within_of(Detector detector, const Positions& at, double distance) {
  return copied(detector.pairs_within(at, distance));
}
inline std::vector<Intersection> intersections_of(Detector detector, const Positions& at) {
  return copied(detector.intersections(at));
}

}  // namespace tamis::test
