// A detector's questions about paths.
#include "detect/detector_state.hpp"
#include "detect/pair_faults.hpp"
#include "detect/validate.hpp"
#include "paths/path_search.hpp"
#include "tamis/error.hpp"

namespace tamis {

/// Validates `asked`, then calls find(search) with the search of this question, and measures it.
template <class Find>
void Detector::State::on_path(const CutPath& path, double keep, const QueryOptions& asked, const Find& find) {
  validate_of_path(asked);
  const Separations kept = separations(asked);
  measure([&] {
    const MeshOnPath whole{
        path.path, kept, asked.tolerance.value_or(PairOptions().tolerance), asked.at_start == AtStart::ignore,
        path.ends, keep};
    PathSearch search(mesh, options, rings_, *engine_, whole, statistics);
    find(search);
  });
}

const std::vector<Contact>& Detector::State::ask(const CutPath& path, const QueryOptions& asked, Question question) {
  if (asked.at_start == AtStart::fail && question == Question::is_free) question = Question::earliest;
  on_path(path, 0, asked, [&](PathSearch& search) {
    found.contacts() = search.find(question);
    sort_found();
  });
  for (const Contact& c : found.contacts())
    if (asked.at_start == AtStart::fail && c.toi_lower == 0)
      throw InvalidStep(features_text(c.kind, c.vertices) +
                        " touch at the start of the path, or are nearer than can be told: move them apart, leave the "
                        "pair out, or ask with at_start ignore");
  return found.contacts();
}

const std::vector<Contact>& Detector::State::find_contacts(const CutPath& path, const QueryOptions& asked) {
  return ask(path, asked, Question::all_contacts);
}

EarliestContact Detector::State::earliest(const CutPath& path, const QueryOptions& asked) {
  return first_of(ask(path, asked, Question::earliest));
}

bool Detector::State::is_free(const CutPath& path, const QueryOptions& asked) {
  return ask(path, asked, Question::is_free).empty();
}

SafeStep Detector::State::safe_step(const CutPath& path, double keep, const QueryOptions& asked) {
  validate_kept(keep);
  SafeStep answer;
  on_path(path, keep, asked, [&](PathSearch& search) { answer = search.find_step_length(); });
  return answer;
}

}  // namespace tamis
