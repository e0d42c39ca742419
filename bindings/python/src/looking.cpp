#include "python/src/looking.hpp"

#include <algorithm>
#include <tuple>

#include "files/view/film.hpp"
#include "files/view/outputs.hpp"
#include "python/src/arrays.hpp"
#include "tamis/error.hpp"

namespace tamis::python {
namespace {

auto key_of(const Contact& c) { return std::tie(c.kind, c.vertices, c.toi_lower, c.toi_upper); }

/// Before the first of all contacts; 1 if there is none.
double free_before(std::span<const Contact> found) {
  double time = 1;
  for (const Contact& c : found) time = std::min(time, c.toi_lower);
  return time;
}

/// REQUIRES: `found` in its fixed order, by kind, then vertices.
bool is_part(std::span<const Contact> part, std::span<const Contact> found) {
  const auto before = [](const Contact& a, const Contact& b) { return key_of(a) < key_of(b); };
  return std::all_of(part.begin(), part.end(),
                     [&](const Contact& c) { return std::binary_search(found.begin(), found.end(), c, before); });
}

Options with(Options options, std::optional<double> min_separation) {
  options.min_separation = min_separation.value_or(options.min_separation);
  return options;
}

}  // namespace

void write_motion(const std::filesystem::path& to, Detector& detector, const Step& step, const QueryOptions& asked,
                  std::span<const Contact> part) {
  const auto& found = detector.contacts(step, asked);
  if (!is_part(part, found))
    throw InvalidStep(
        "the positions have changed since these contacts were found: look at contacts before the next step, or give "
        "the detector arrays that stay as they are");
  const Options options = with(detector.options(), asked.min_separation);
  io::Recording recording{detector.mesh(),
                          options,
                          1,
                          {"start", "end"},
                          {points_of(step.start), points_of(step.end)},
                          {{{part.begin(), part.end()}, detector.statistics().stages}}};
  recording.at_start = asked.at_start;
  recording.steps.front().ignored = detector.statistics().ignored;
  if (part.size() < found.size()) recording.steps.front().free_before = free_before(found);
  io::output_for(to, io::outputs()).write(to, recording);
}

void write_motion(const std::filesystem::path& to, Detector& detector, const Path& path, const PathOptions& asked,
                  std::span<const Contact> part) {
  const io::Output& output = io::output_for(to, io::outputs());
  if (!output.holds_sequence)
    throw Error(to.string() + " would hold one straight piece, and these contacts are of a path: save html or csv");
  const auto& found = detector.contacts(path, asked);
  if (!is_part(part, found))
    throw InvalidPath("the path has changed since these contacts were found: look at them before it does");
  const Options options = with(detector.options(), asked.min_separation);
  io::Recording film{detector.mesh(), options, 1, {}, {}, {}};
  film.at_start = asked.at_start;
  io::add_path(film, path, {part, free_before(found), detector.statistics().ignored});
  output.write(to, film);
}

}  // namespace tamis::python
