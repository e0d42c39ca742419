#include "c/options.hpp"

#include <cstddef>
#include <string>

#include "c/sized.hpp"
#include "tamis/error.hpp"

namespace tamis::c {
namespace {

PairFilter filter_of(const tamis_options& given, Index vertex_count) {
  if (given.group_count < 0)
    throw InvalidOptions("group_count is " + std::to_string(given.group_count) + ": give at least one group, or 0");
  PairFilter filter;
  filter.group_count = given.group_count == 0 ? 1 : given.group_count;
  if (given.group_of_vertex) filter.group_of_vertex.assign(given.group_of_vertex, given.group_of_vertex + vertex_count);
  if (given.groups_may_touch) {
    const auto groups = static_cast<std::size_t>(filter.group_count);
    filter.groups_may_touch.assign(given.groups_may_touch,
                                   given.groups_may_touch + product(groups, groups, "group_count"));
  }
  if (given.rings != 0) filter.rings = given.rings;
  if (given.accepts)
    filter.accepts = [ask = given.accepts, user = given.user](PairKind kind, const std::array<Index, 4>& vertices) {
      return ask(user, static_cast<int32_t>(kind), vertices.data()) != 0;
    };
  return filter;
}

/// Reads the options that detectors, worlds and lists of pairs share.
template <typename Read, typename Given>
Read shared_options(const Given& given) {
  Read options;
  options.isa = isa_of(given.isa);
  options.threads = given.threads;
  options.min_separation = given.min_separation;
  options.is_cancelled = cancelling(given.is_cancelled, given.user);
  if (given.parallel_for)
    options.parallel_for = [run = given.parallel_for, user = given.user](int count,
                                                                         const std::function<void(int)>& body) {
      const auto call = [](void* loop, int32_t i) { (*static_cast<const std::function<void(int)>*>(loop))(i); };
      run(user, count, call, const_cast<std::function<void(int)>*>(&body));
    };
  return options;
}

}  // namespace

Isa isa_of(const char* name) { return name ? isa_from_name(name) : Isa::best; }

std::function<bool()> cancelling(int (*ask)(void* user), void* user) {
  if (!ask) return nullptr;
  return [ask, user] { return ask(user) != 0; };
}

Options options_of(const tamis_options& given, Index vertex_count) {
  auto options = shared_options<Options>(given);
  options.filter = filter_of(given, vertex_count);
  if (given.radii) options.radii.assign(given.radii, given.radii + options.filter.group_count);
  return options;
}

PairOptions options_of(const tamis_pair_options& given) {
  auto options = shared_options<PairOptions>(given);
  if (given.latest) options.latest = *given.latest;
  return options;
}

Options options_of(const tamis_world_options& given) {
  auto options = shared_options<Options>(given);
  if (given.rings != 0) options.filter.rings = given.rings;
  return options;
}

}  // namespace tamis::c
