// The layouts of the tables that answers are.
#include <nanobind/stl/string.h>

#include "python/src/bindings.hpp"
#include "python/src/layout.hpp"
#include "tamis/pair.hpp"
#include "tamis/world.hpp"

namespace tamis::python {
namespace {

namespace nb = nanobind;

template <class Record>
Layout<Record> contact_layout() {
  return Layout<Record>()
      .field("kind", &Contact::kind)
      .field("certainty", &Contact::certainty)
      .field("vertices", &Contact::vertices)
      .field("toi_lower", &Contact::toi_lower)
      .field("toi_upper", &Contact::toi_upper)
      .field("u", &Contact::u)
      .field("v", &Contact::v)
      .field("normal", &Contact::normal);
}

template <class Record>
Layout<Record> near_layout() {
  return Layout<Record>()
      .field("kind", &NearPair::kind)
      .field("vertices", &NearPair::vertices)
      .field("distance", &NearPair::distance)
      .field("u", &NearPair::u)
      .field("v", &NearPair::v)
      .field("direction", &NearPair::direction);
}

template <class Record>
Layout<Record> intersection_layout() {
  return Layout<Record>()
      .field("edge", &Intersection::edge)
      .field("face", &Intersection::face)
      .field("s_lower", &Intersection::s_lower)
      .field("s_upper", &Intersection::s_upper)
      .field("u", &Intersection::u)
      .field("v", &Intersection::v);
}

nb::dict pair_layout() {
  return Layout<PairResult>()
      .field("touches", &PairResult::touches)
      .field("certainty", &PairResult::certainty)
      .field("toi_lower", &PairResult::toi_lower)
      .field("toi_upper", &PairResult::toi_upper)
      .field("u", &PairResult::u)
      .field("v", &PairResult::v)
      .field("normal", &PairResult::normal)
      .dict();
}

/// Of an answer about bodies: what is said of a pair, and whose it is.
template <class Record>
nb::dict of_bodies(Layout<Record> layout) {
  return layout.field("bodies", &Record::bodies).dict();
}

}  // namespace

void bind_layouts(nb::module_& module) {
  module.def("contact_layout", [] { return contact_layout<Contact>().dict(); });
  module.def("near_layout", [] { return near_layout<NearPair>().dict(); });
  module.def("intersection_layout", [] { return intersection_layout<Intersection>().dict(); });
  module.def("body_contact_layout", [] { return of_bodies(contact_layout<BodyContact>()); });
  module.def("body_near_layout", [] { return of_bodies(near_layout<BodyNearPair>()); });
  module.def("body_intersection_layout", [] { return of_bodies(intersection_layout<BodyIntersection>()); });
  module.def("pair_layout", &pair_layout);
}

}  // namespace tamis::python
