// contacts, earliest and is_free of a world.
#include <algorithm>

#include "detect/validate.hpp"
#include "paths/path_search.hpp"
#include "query/contact_collector.hpp"
#include "world/ordered_parts.hpp"
#include "world/world_state.hpp"

namespace tamis {

std::vector<BodyContact> World::State::contacts(const QueryOptions& asked) {
  validate_of_path(asked);
  OrderedParts<BodyContact> parts;
  const auto add = [&](const std::vector<Contact>& contacts, const auto& whose) {
    for (const Contact& c : contacts) parts.add(named<BodyContact>(c, whose));
    parts.end_part();
    return true;
  };
  for_each_by_itself(
      [&](BodyId id, Body& body, Detector& itself) { return add(itself.contacts(body.step(), of_steps(asked)), id); });
  gather_moving({separation(asked)});
  for_each_gathered(
      asked,
      [&](Gathered& gathered, const Step& step, const QueryOptions& how) {
        // What else is in the mesh depends on earlier questions.
        return add(gathered.locked()->find_contacts(step, how, true), gathered);
      },
      [&](Gathered& gathered, const CutPath& path, const QueryOptions& how) {
        return add(gathered.locked()->ask(path, how, Question::all_contacts), gathered);
      });
  std::vector<BodyContact> all = std::move(parts).merged();
  if (asked.at_start == AtStart::fail)
    for (const BodyContact& c : all)
      if (c.toi_lower == 0) refuse_touching_start(c.kind, c.vertices, c.bodies);
  return all;
}

EarliestBodyContact World::State::earliest(const QueryOptions& asked) {
  validate_of_path(asked);
  EarliestBodyContact first;
  const auto take = [&](const EarliestContact& found, const auto& whose) {
    first.toi_upper = std::min(first.toi_upper, found.toi_upper);
    take_sooner(first.contact, first.toi_lower, found.contact, found.toi_lower, whose);
    return true;
  };
  for_each_by_itself(
      [&](BodyId id, Body& body, Detector& itself) { return take(itself.earliest(body.step(), of_steps(asked)), id); });
  gather_moving({separation(asked)});
  for_each_gathered(
      asked,
      [&](Gathered& gathered, const Step& step, const QueryOptions& how) {
        return take(gathered.detector().earliest(step, how), gathered);
      },
      [&](Gathered& gathered, const CutPath& path, const QueryOptions& how) {
        return take(first_of(gathered.locked()->ask(path, how, Question::earliest)), gathered);
      });
  check_start(first, asked);
  return first;
}

bool World::State::is_free(const QueryOptions& asked) {
  if (asked.at_start == AtStart::fail) return !earliest(asked).contact;
  validate_of_path(asked);
  gather_moving({separation(asked)});
  bool is_free = true;
  for_each_gathered(
      asked,
      [&](Gathered& gathered, const Step& step, const QueryOptions& how) {
        return is_free = gathered.detector().is_free(step, how);
      },
      [&](Gathered& gathered, const CutPath& path, const QueryOptions& how) {
        return is_free = gathered.locked()->ask(path, how, Question::is_free).empty();
      });
  if (is_free)
    for_each_by_itself(
        [&](BodyId, Body& body, Detector& itself) { return is_free = itself.is_free(body.step(), of_steps(asked)); });
  return is_free;
}

}  // namespace tamis
