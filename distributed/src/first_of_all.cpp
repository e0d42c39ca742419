#include "distributed/src/first_of_all.hpp"

#include <algorithm>
#include <tuple>

namespace tamis::distributed {
namespace {

template <class T, class Time, class Pair>
T first_of_all(Communicator& communicator, const T& mine, const Time& time_of, const Pair& pair_of) {
  const double least = communicator.least(pair_of(mine) ? time_of(mine) : 2);
  Packer packer;
  if (pair_of(mine) && time_of(mine) == least) packer.put(mine);
  T first{};
  for (const Bytes& bytes : communicator.gather_for_all(packer.take())) {
    if (bytes.empty()) continue;
    const T other = Unpacker(bytes).template get<T>();
    const auto &a = pair_of(other), &b = pair_of(first);
    if (!b || std::tie(a->kind, a->vertices) < std::tie(b->kind, b->vertices)) first = other;
  }
  return first;
}

}  // namespace

EarliestContact first_of_all(Communicator& communicator, const EarliestContact& mine) {
  EarliestContact first = first_of_all(
      communicator, mine, [](const EarliestContact& e) { return e.toi_lower; },
      [](const EarliestContact& e) -> const auto& { return e.contact; });
  first.toi_upper = communicator.least(mine.toi_upper);
  return first;
}

SafeStep first_of_all(Communicator& communicator, const SafeStep& mine) {
  return first_of_all(
      communicator, mine, [](const SafeStep& s) { return s.toi_lower; },
      [](const SafeStep& s) -> const auto& { return s.pair; });
}

void keep_first(EarliestContact& first, const EarliestContact& other) {
  const double upper = std::min(first.toi_upper, other.toi_upper);
  const auto key = [](const EarliestContact& e) {
    return std::tuple(e.toi_lower, e.contact->kind, e.contact->vertices);
  };
  if (other.contact && (!first.contact || key(other) < key(first))) first = other;
  first.toi_upper = upper;
}

void keep_first(SafeStep& first, const SafeStep& other) {
  const auto key = [](const SafeStep& s) { return std::tuple(s.toi_lower, s.pair->kind, s.pair->vertices); };
  if (other.pair && (!first.pair || key(other) < key(first))) first = other;
}

}  // namespace tamis::distributed
