// A detector's questions about paths.
#include "api/detector_state.hpp"
#include "api/pair_faults.hpp"
#include "api/validate.hpp"
#include "curves/paths/callers_path.hpp"
#include "curves/paths/path_search.hpp"
#include "search/kernels/kernels.hpp"
#include "tamis/error.hpp"

namespace tamis {

/// Validates `asked`, then calls find(search) with the search of this question, and measures it.
template <class Find>
void Detector::State::on_path(const CutPath& path, double keep, const PathOptions& asked, Question question,
                              const BodyPairs* each_of, const Find& find) {
  validate(asked);
  const Query whole = asked_query({}, {asked.min_separation, asked.at_start}, question, each_of);
  const CallersPath callers(path.path);
  measure([&] {
    const MeshOnPath on_path{callers, whole, asked.tolerance, path.ends, keep};
    PathSearch search(mesh, on_path, *engine_, kernels(options.isa), statistics);
    find(search);
  });
}

EarliestContact Detector::State::find(const CutPath& path, const PathOptions& asked, Question question,
                                      const BodyPairs* each_of) {
  on_path(path, 0, asked, question, each_of, [&](PathSearch& search) {
    found.contacts() = search.find();
    sort_found();
  });
  for (const Contact& c : found.contacts())
    if (asked.at_start == AtStart::fail && c.toi_lower == 0)
      throw InvalidStep(features_text(c.kind, c.vertices) +
                        " touch at the start of the path, or are nearer than can be told: move them apart, leave the "
                        "pair out, or pass at_start ignore");
  return first_of(found.contacts());
}

SafeStep Detector::State::safe_step(const CutPath& path, double keep, const PathOptions& asked) {
  validate_kept(keep);
  SafeStep answer;
  on_path(path, keep, asked, Question::earliest, nullptr,
          [&](PathSearch& search) { answer = search.find_step_length(); });
  return answer;
}

}  // namespace tamis
