#include "python/src/statistics.hpp"

#include <nanobind/stl/string.h>

#include <string>
#include <utility>

namespace tamis::python {
namespace {

namespace nb = nanobind;

/// Numbers by their names.
template <class Number>
nb::dict named(std::initializer_list<std::pair<const char*, Number>> numbers) {
  nb::dict result;
  for (const auto& [name, number] : numbers) result[name] = number;
  return result;
}

nb::dict seconds_by_stage(const Seconds& s) {
  return named<double>({{"bounds", s.bounds},
                        {"build", s.build},
                        {"traverse", s.traverse},
                        {"filter", s.filter},
                        {"solve", s.solve},
                        {"total", s.total}});
}

nb::dict pairs_by_arithmetic(const PrecisionCount& count) {
  return named<std::uint64_t>(
      {{"lanes", count.lanes}, {"scalar", count.scalar}, {"exact", count.exact}, {"unresolved", count.unresolved}});
}

}  // namespace

nb::dict as_dict(const Statistics& s) {
  nb::dict stages, all;
  for (const auto& [name, vf, ee, ve, vv] : s.stages)
    stages[nb::str(name.data(), name.size())] = nb::make_tuple(vf, ee, ve, vv);
  all["isa"] = std::string(name_of(s.isa));
  all["threads"] = s.threads;
  all["stages"] = stages;
  all["decided_by"] = pairs_by_arithmetic(s.decided_by);
  all["seconds"] = seconds_by_stage(s.seconds);
  all["ignored"] = s.ignored;
  all["nodes_visited"] = s.nodes_visited;
  all["rebuilt"] = s.rebuilt;
  all["memory_bytes"] = s.memory_bytes;
  return all;
}

}  // namespace tamis::python
