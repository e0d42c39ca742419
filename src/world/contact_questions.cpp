// contacts, earliest and is_free of a world.
#include <algorithm>
#include <functional>

#include "detect/validate.hpp"
#include "numerics/assert.hpp"
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

/// Contacts in parts each of which is in order.
class ContactParts {
 public:
  void add(const BodyContact& contact) { all_.push_back(contact); }
  void end_part() {
    TAMIS_ASSERT(std::is_sorted(at(last_end()), all_.end(), is_before<BodyContact>));
    ends_.push_back(all_.size());
  }
  /// All in order.
  std::vector<BodyContact> merged() && {
    while (ends_.size() > 1) {
      std::vector<std::size_t> ends;
      std::size_t first = 0;
      for (std::size_t i = 0; i < ends_.size(); i += 2) {
        const std::size_t last = ends_[std::min(i + 1, ends_.size() - 1)];
        std::inplace_merge(at(first), at(ends_[i]), at(last), is_before<BodyContact>);
        ends.push_back(first = last);
      }
      ends_ = std::move(ends);
    }
    return std::move(all_);
  }

 private:
  std::size_t last_end() const { return ends_.empty() ? 0 : ends_.back(); }
  std::vector<BodyContact>::iterator at(std::size_t i) { return all_.begin() + static_cast<std::ptrdiff_t>(i); }

  std::vector<BodyContact> all_;
  std::vector<std::size_t> ends_;
};

}  // namespace

std::vector<BodyContact> World::State::contacts(const QueryOptions& asked) {
  validate_of_path(asked);
  ContactParts parts;
  for_each_by_itself([&](BodyId id, Body& body, Detector& itself) {
    for (const Contact& c : itself.contacts(body.step(), of_steps(asked))) parts.add({c, twice(id)});
    parts.end_part();
    return true;
  });
  gather_moving({separation(asked)});
  const auto add = [&](const Gathered& gathered, const std::vector<Contact>& contacts) {
    for (const Contact& c : contacts) parts.add(named(c, gathered));
    parts.end_part();
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
  std::vector<BodyContact> all = std::move(parts).merged();
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
    return true;
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
    for_each_by_itself(
        [&](BodyId, Body& body, Detector& itself) { return is_free = itself.is_free(body.step(), of_steps(asked)); });
  return is_free;
}

}  // namespace tamis
