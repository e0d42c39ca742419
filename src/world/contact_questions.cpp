// contacts, earliest and is_free of a world.
#include <algorithm>

#include "detect/validate.hpp"
#include "world/ordered_parts.hpp"
#include "world/world_state.hpp"

namespace tamis {

std::vector<BodyContact> World::State::contacts(const QueryOptions& asked) {
  validate_of_path(asked);
  OrderedParts<BodyContact> parts;
  for_each_moving({separation(asked)}, asked,
                  [&](const auto& state, const auto& motion, const QueryOptions& how, const auto& whose) {
                    for (const Contact& c : state->find_contacts(motion, how)) parts.add(named<BodyContact>(c, whose));
                    parts.end_part();
                    return true;
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
  for_each_moving({separation(asked)}, asked,
                  [&](const auto& state, const auto& motion, const QueryOptions& how, const auto& whose) {
                    const EarliestContact found = state->earliest(motion, how);
                    first.toi_upper = std::min(first.toi_upper, found.toi_upper);
                    take_sooner(first.contact, first.toi_lower, found.contact, found.toi_lower, whose);
                    return true;
                  });
  check_start(first, asked);
  return first;
}

bool World::State::is_free(const QueryOptions& asked) {
  if (asked.at_start == AtStart::fail) return !earliest(asked).contact;
  validate_of_path(asked);
  bool is_free = true;
  for_each_moving({separation(asked)}, asked,
                  [&](const auto& state, const auto& motion, const QueryOptions& how, const auto&) {
                    return is_free = state->is_free(motion, how);
                  });
  return is_free;
}

}  // namespace tamis
