#include <fmt/format.h>

#include "command/command_line/printable.hpp"
#include "command/report.hpp"
#include "files/system.hpp"

namespace tamis::cli {

Json json_of(const Seconds& s) {
  return {{"bounds", s.bounds}, {"build", s.build}, {"traverse", s.traverse},
          {"filter", s.filter}, {"solve", s.solve}, {"total", s.total}};
}

Json json_of(const Contact& c) {
  return {{"kind", name_of(c.kind)},
          {"vertices", c.vertices},
          {"toi_lower", c.toi_lower},
          {"toi_upper", c.toi_upper},
          {"u", c.u},
          {"v", c.v},
          {"normal", c.normal}};
}

Json json_of(const NearPair& pair) {
  return {{"kind", name_of(pair.kind)},
          {"vertices", pair.vertices},
          {"distance", pair.distance},
          {"u", pair.u},
          {"v", pair.v},
          {"direction", pair.direction}};
}

void add_costs(Json& json, const Detector& detector, const Timing& timing) {
  const Statistics& statistics = detector.statistics();
  json["seconds"] = json_of(timing.warm);
  json["seconds_cold"] = json_of(timing.cold);
  add_stages(json, statistics.stages);
  const PrecisionCount& p = statistics.decided_by;
  json["decided_by"] = {{"lanes", p.lanes}, {"scalar", p.scalar}, {"exact", p.exact}};
  json["ignored"] = statistics.ignored;
  json["nodes_visited"] = statistics.nodes_visited;
  json["peak_memory_bytes"] = system::peak_memory_bytes();
  json["detector_memory_bytes"] = statistics.memory_bytes;
  json["threads"] = statistics.threads;
  json["min_separation"] = detector.options().min_separation;
  json["radii"] = detector.options().radii;
  json["isa"] = name_of(statistics.isa);
  const Mesh& mesh = detector.mesh();
  json["mesh"] = {
      {"vertices", mesh.vertex_count()}, {"triangles", mesh.faces().size()}, {"edges", mesh.edges().size()}};
}

namespace {

/// Names of files may hold any byte, JSON may not.
Json with_utf8_text(const Json& json) {
  if (json.is_string()) return utf8_text(json.get_ref<const std::string&>());
  if (!json.is_structured()) return json;
  Json result = json.is_array() ? Json::array() : Json::object();
  for (const auto& [key, value] : json.items())
    if (json.is_array())
      result.push_back(with_utf8_text(value));
    else
      result[utf8_text(key)] = with_utf8_text(value);
  return result;
}

}  // namespace

// In ASCII: a terminal obeys control characters beyond ASCII, too.
void print_json(const Json& json) { fmt::print("{}\n", with_utf8_text(json).dump(2, ' ', true)); }

}  // namespace tamis::cli
