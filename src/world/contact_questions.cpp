// contacts, earliest and is_free of a world.
#include <algorithm>
#include <functional>
#include <map>

#include "detect/make_detector.hpp"
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
  const auto add = [&](Part& part, const std::vector<Contact>& contacts) {
    for (const Contact& c : contacts) all.push_back(named(c, *part.gathered));
    add_statistics(part.gathered->detector().statistics());
  };
  if (straight_.is_asked()) {
    Gathered& gathered = *straight_.gathered;
    const Step step = gathered.step(bodies);
    std::vector<Contact> found;
    gathered.detector().contacts(step, found, of_steps(asked));
    decide_anew(found, step, asked);
    add(straight_, found);
  }
  if (turning_.is_asked()) {
    const RigidPath path = turning_.gathered->path(bodies);
    add(turning_, DetectorMaker::ask(turning_.gathered->detector(), path, of_curves(asked), Question::all_contacts,
                                     std::span(times_).subspan(1)));
  }
  std::ranges::sort(all, is_before<BodyContact>);
  if (asked.at_start == AtStart::fail)
    for (const BodyContact& c : all)
      if (c.toi_lower == 0) refuse_touching_start(c.kind, c.vertices, c.bodies);
  return all;
}

/// The last digits of what a detector finds depend on what else is in its mesh, which here depends on earlier
/// questions: the narrow phase knows of the pair alone. What was ignored at the start has been decided so already.
void World::State::decide_anew(std::vector<Contact>& contacts, const Step& step, const QueryOptions& asked) const {
  std::map<double, std::vector<std::size_t>> by_separation;
  for (std::size_t i = 0; i < contacts.size(); ++i)
    by_separation[separation(asked) + straight_.gathered->radii(contacts[i].kind, contacts[i].vertices)].push_back(i);
  PairListOptions of_list;
  of_list.threads = options.threads;
  of_list.isa = options.isa;
  of_list.is_cancelled = options.is_cancelled;
  for (const auto& [separation, places] : by_separation) {
    std::vector<Pair> pairs;
    for (const std::size_t i : places) pairs.push_back({contacts[i].kind, contacts[i].vertices});
    of_list.min_separation = separation;
    const std::vector<PairResult> results = narrow_phase(pairs, step, of_list);
    for (std::size_t k = 0; k < places.size(); ++k) {
      Contact& contact = contacts[places[k]];
      if (asked.at_start != AtStart::ignore || results[k].toi_upper > 0)
        contact = contact_of(contact.kind, contact.vertices, results[k]);
    }
  }
}

EarliestBodyContact World::State::earliest(const QueryOptions& asked) {
  validate_of_path(asked);
  EarliestBodyContact first;
  for_each_by_itself([&](BodyId id, Body& body, Detector& itself) {
    const EarliestContact own = itself.earliest(body.step(), of_steps(asked));
    take_sooner(first, own, [&] { return BodyContact{*own.contact, twice(id)}; });
  });
  gather_moving({separation(asked)});
  const auto take = [&](Part& part, const EarliestContact& found) {
    take_sooner(first, found, [&] { return named(*found.contact, *part.gathered); });
    add_statistics(part.gathered->detector().statistics());
  };
  if (straight_.is_asked()) {
    Gathered& gathered = *straight_.gathered;
    take(straight_, gathered.detector().earliest(gathered.step(bodies), of_steps(asked)));
  }
  if (turning_.is_asked()) {
    const RigidPath path = turning_.gathered->path(bodies);
    take(turning_, first_of(DetectorMaker::ask(turning_.gathered->detector(), path, of_curves(asked),
                                               Question::earliest, std::span(times_).subspan(1))));
  }
  check_start(first, asked);
  return first;
}

bool World::State::is_free(const QueryOptions& asked) {
  if (asked.at_start == AtStart::fail) return !earliest(asked).contact;
  validate_of_path(asked);
  gather_moving({separation(asked)});
  bool is_free = true;
  const auto take = [&](Part& part, bool part_is_free) {
    add_statistics(part.gathered->detector().statistics());
    is_free &= part_is_free;
  };
  if (straight_.is_asked()) {
    Gathered& gathered = *straight_.gathered;
    take(straight_, gathered.detector().is_free(gathered.step(bodies), of_steps(asked)));
  }
  if (turning_.is_asked() && is_free) {
    const RigidPath path = turning_.gathered->path(bodies);
    take(turning_, DetectorMaker::ask(turning_.gathered->detector(), path, of_curves(asked), Question::is_free,
                                      std::span(times_).subspan(1))
                       .empty());
  }
  if (is_free)
    for_each_by_itself([&](BodyId, Body& body, Detector& itself) {
      is_free = is_free && itself.is_free(body.step(), of_steps(asked));
    });
  return is_free;
}

}  // namespace tamis
