// contacts, earliest and is_free of a world.
#include <algorithm>
#include <functional>

#include "detect/validate.hpp"
#include "paths/path_search.hpp"
#include "query/contact_collector.hpp"
#include "world/named_pairs.hpp"
#include "world/world_state.hpp"

namespace tamis {
namespace {

/// Takes what comes sooner.
void take_sooner(EarliestBodyContact& first, const EarliestContact& other,
                 const std::function<BodyContact()>& contact) {
  first.toi_upper = std::min(first.toi_upper, other.toi_upper);
  if (!other.contact || other.toi_lower > first.toi_lower) return;
  BodyContact named = contact();
  if (first.contact && other.toi_lower == first.toi_lower && !is_before(named, *first.contact)) return;
  first.toi_lower = other.toi_lower;
  first.contact = named;
}

BodyContact named(const Contact& contact, const Gathered& gathered) {
  BodyContact result{contact, {}};
  result.bodies = gathered.name(contact.kind, result.vertices);
  return result;
}

}  // namespace

std::vector<BodyContact> World::State::contacts(const QueryOptions& asked) {
  validate_of_path(asked);
  std::vector<BodyContact> all;
  for_each_by_itself([&](BodyId id, Body& body, Detector& itself) {
    for (const Contact& c : itself.contacts(body.step(), of_steps(asked))) all.push_back({c, twice(id)});
  });
  gather_moving({separation(asked)});
  const auto add = [&](const Gathered& gathered, const std::vector<Contact>& contacts) {
    for (const Contact& c : contacts) all.push_back(named(c, gathered));
    return true;
  };
  for_each_gathered(
      asked,
      [&](Gathered& gathered, const Step& step, const QueryOptions& how) {
        // What else is in the mesh depends on earlier questions.
        return add(gathered, DetectorAccess::contacts_by_pair(gathered.detector(), step, how));
      },
      [&](Gathered& gathered, const CutPath& path, const QueryOptions& how) {
        return add(gathered, DetectorAccess::ask(gathered.detector(), path, how, Question::all_contacts));
      });
  std::ranges::sort(all, is_before<BodyContact>);
  if (asked.at_start == AtStart::fail)
    for (const BodyContact& c : all)
      if (c.toi_lower == 0) refuse_touching_start(c.kind, c.vertices, c.bodies);
  return all;
}

EarliestBodyContact World::State::earliest(const QueryOptions& asked) {
  validate_of_path(asked);
  EarliestBodyContact first;
  for_each_by_itself([&](BodyId id, Body& body, Detector& itself) {
    const EarliestContact own = itself.earliest(body.step(), of_steps(asked));
    take_sooner(first, own, [&] { return BodyContact{*own.contact, twice(id)}; });
  });
  gather_moving({separation(asked)});
  const auto take = [&](const Gathered& gathered, const EarliestContact& found) {
    take_sooner(first, found, [&] { return named(*found.contact, gathered); });
    return true;
  };
  for_each_gathered(
      asked,
      [&](Gathered& gathered, const Step& step, const QueryOptions& how) {
        return take(gathered, gathered.detector().earliest(step, how));
      },
      [&](Gathered& gathered, const CutPath& path, const QueryOptions& how) {
        return take(gathered, first_of(DetectorAccess::ask(gathered.detector(), path, how, Question::earliest)));
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
        return is_free = DetectorAccess::ask(gathered.detector(), path, how, Question::is_free).empty();
      });
  if (is_free)
    for_each_by_itself([&](BodyId, Body& body, Detector& itself) {
      is_free = is_free && itself.is_free(body.step(), of_steps(asked));
    });
  return is_free;
}

}  // namespace tamis
