// The layouts of the tables that answers are.
#include <nanobind/stl/string.h>

#include "python/src/bindings.hpp"
#include "python/src/layout.hpp"
#include "tamis/pair.hpp"
#include "tamis/proximity.hpp"

namespace tamis::python {
namespace {

namespace nb = nanobind;

nb::dict contact_layout() {
  return Layout<Contact>()
      .field("kind", &Contact::kind)
      .field("certainty", &Contact::certainty)
      .field("vertices", &Contact::vertices)
      .field("toi_lower", &Contact::toi_lower)
      .field("toi_upper", &Contact::toi_upper)
      .field("u", &Contact::u)
      .field("v", &Contact::v)
      .field("normal", &Contact::normal)
      .dict();
}

nb::dict near_layout() {
  return Layout<NearPair>()
      .field("kind", &NearPair::kind)
      .field("corners", &NearPair::corners)
      .field("vertices", &NearPair::vertices)
      .field("distance", &NearPair::distance)
      .field("u", &NearPair::u)
      .field("v", &NearPair::v)
      .field("direction", &NearPair::direction)
      .dict();
}

nb::dict intersection_layout() {
  return Layout<Intersection>()
      .field("edge", &Intersection::edge)
      .field("face", &Intersection::face)
      .field("s_lower", &Intersection::s_lower)
      .field("s_upper", &Intersection::s_upper)
      .field("u", &Intersection::u)
      .field("v", &Intersection::v)
      .dict();
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

}  // namespace

void bind_layouts(nb::module_& module) {
  module.def("contact_layout", &contact_layout);
  module.def("near_layout", &near_layout);
  module.def("intersection_layout", &intersection_layout);
  module.def("pair_layout", &pair_layout);
}

}  // namespace tamis::python
