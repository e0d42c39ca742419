#include "support/yardstick/methods.hpp"

#include <utility>

#include "api/detector_access.hpp"
#include "support/yardstick/brute.hpp"

namespace tamis::yardstick {

std::string_view name_of(Method method) { return method == Method::brute ? "brute" : "tamis"; }

Detector make_detector(Mesh mesh, const Options& options) {
  const auto make_engine = [&](const Mesh& of, const tamis::Options& given) {
    return options.method == Method::brute ? make_brute_engine(of, given) : make_tamis_engine(of, given);
  };
  return DetectorAccess::make(std::move(mesh), options.of_library(), make_engine);
}

}  // namespace tamis::yardstick
