#include "python/src/looking.hpp"

#include <algorithm>
#include <tuple>

#include "io/view/outputs.hpp"
#include "tamis/error.hpp"

namespace tamis::python {
namespace {

auto key_of(const Contact& c) { return std::tie(c.kind, c.vertices, c.toi_lower, c.toi_upper); }

/// REQUIRES: `found` in its fixed order, by kind, then vertices.
void require_part(std::span<const Contact> part, std::span<const Contact> found) {
  const auto before = [](const Contact& a, const Contact& b) { return key_of(a) < key_of(b); };
  if (!std::all_of(part.begin(), part.end(),
                   [&](const Contact& c) { return std::binary_search(found.begin(), found.end(), c, before); }))
    throw InvalidStep(
        "the positions have changed since these contacts were found: look at contacts before the next step, or give "
        "the "
        "detector arrays that stay as they are");
}

std::vector<Point> points_of(const Positions& positions) {
  std::vector<Point> points;
  points.reserve(static_cast<std::size_t>(positions.count()));
  for (Index v = 0; v < positions.count(); ++v) points.push_back({positions[v][0], positions[v][1], positions[v][2]});
  return points;
}

}  // namespace

void write_step(const std::filesystem::path& path, Detector& detector, const Step& step,
                std::optional<double> min_separation, std::span<const Contact> part) {
  require_part(part, detector.contacts(step, min_separation));
  Options options = detector.options();
  options.min_separation = min_separation.value_or(options.min_separation);
  const io::Recording recording{detector.mesh(),
                                options,
                                1,
                                {"start", "end"},
                                {points_of(step.start), points_of(step.end)},
                                {{{part.begin(), part.end()}, detector.statistics().stages}}};
  io::find_output(io::outputs(), path)->write(path, recording);
}

}  // namespace tamis::python
