#include "paper/detector.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "api/detector_access.hpp"
#include "api/enum_names.hpp"
#include "paper/pipeline/engine.hpp"
#include "support/yardstick/brute.hpp"

namespace tamis::lab {
namespace {

void check(bool ok, const std::string& message) {
  if (!ok) throw InvalidOptions(message);
}

bool are_finite(std::span<const double> numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
}

void validate(const ReducedModel& model, const Mesh& mesh) {
  const auto n = static_cast<std::size_t>(mesh.vertex_count());
  check(model.modes > 0, "the reduced model has " + std::to_string(model.modes) + " modes: give at least one");
  check(model.rest.size() == n, "the reduced model has " + std::to_string(model.rest.size()) +
                                    " rest positions, the mesh " + std::to_string(n) + " vertices: give one a vertex");
  const std::size_t size = 3 * n * static_cast<std::size_t>(model.modes);
  check(model.basis.size() == size, "the basis of the reduced model has " + std::to_string(model.basis.size()) +
                                        " entries: give 3 x vertices x modes = " + std::to_string(size));
  const bool is_finite = are_finite(model.basis) && std::all_of(model.rest.begin(), model.rest.end(),
                                                                [](const Point& p) { return are_finite(p); });
  check(is_finite, "the reduced model has an entry that is not finite: give finite rest positions and modes");
}

void validate(const PaperOptions& paper, const Mesh& mesh) {
  validate_is_named(paper.bounding_volume, "bounding volume");
  check(paper.high_level <= HighLevelCulling::subspace, "no high-level culling has the number " +
                                                            std::to_string(static_cast<int>(paper.high_level)) +
                                                            ": use one of the enumeration's names");
  if (paper.high_level != HighLevelCulling::subspace) return;
  check(paper.reduced_model != nullptr, "subspace culling needs a reduced model: set paper.reduced_model");
  validate(*paper.reduced_model, mesh);
}

}  // namespace

Detector make_detector(Mesh mesh, const Options& options, TriangleCounts* counts) {
  validate_is_named(options.method, "method");
  validate(options.paper, mesh);
  const auto make_engine = [&](const Mesh& of, const tamis::Options& given) {
    switch (options.method) {
      case Method::paper:
        return make_paper_engine(of, given, options.paper, counts);
      case Method::brute:
        return yardstick::make_brute_engine(of, given);
      case Method::tamis:
        break;
    }
    return make_tamis_engine(of, given);
  };
  return DetectorAccess::make(std::move(mesh), options.of_library(), make_engine);
}

}  // namespace tamis::lab
