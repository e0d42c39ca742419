#include "files/view/scene_bytes.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "files/mesh/loose_features.hpp"
#include "files/output/contact_geometry.hpp"
#include "files/tally.hpp"
#include "files/view/columns.hpp"
#include "files/view/quantised.hpp"
#include "tamis/components.hpp"

namespace tamis::io {
namespace {

std::uint32_t bits_of(Index index) { return static_cast<std::uint32_t>(index); }

/// Columns one behind the other, and where each begins.
class Columns {
 public:
  /// `write` appends to the bytes.
  template <class Write>
  void add(const char* name, std::size_t count, const Write& write) {
    list_[name] = {{"offset", bytes_.size()}, {"count", count}};
    write(bytes_);
  }
  void add_integers(const char* name, std::span<const std::uint32_t> column, std::size_t width) {
    add(name, column.size(), [&](std::string& bytes) { append_differences(bytes, column, width); });
  }
  template <class Number>
  void add_planes(const char* name, const std::vector<Number>& column) {
    add(name, column.size(), [&](std::string& bytes) { append_planes<Number>(bytes, column); });
  }
  const Json& list() const { return list_; }
  const std::string& bytes() const { return bytes_; }

 private:
  Json list_ = Json::object();
  std::string bytes_;
};

template <class Row, std::size_t width = std::tuple_size_v<Row>>
std::vector<std::uint32_t> flat_bits(std::span<const Row> rows) {
  std::vector<std::uint32_t> numbers;
  numbers.reserve(width * rows.size());
  for (const Row& row : rows)
    for (const Index i : row) numbers.push_back(bits_of(i));
  return numbers;
}

audit::Objects objects_of(const Recording& recording) {
  return recording.objects ? *recording.objects : audit::Objects{components_of(recording.mesh).of_vertex};
}

void add_mesh(const Recording& recording, Columns& columns, Json& header) {
  const Mesh& mesh = recording.mesh;
  std::vector<std::uint32_t> loose;
  for (const Index v : loose_points_of(mesh)) loose.push_back(bits_of(v));
  const audit::Objects shown = objects_of(recording);
  std::vector<std::uint32_t> objects;
  objects.reserve(shown.of_vertex.size());
  for (const Index object : shown.of_vertex) objects.push_back(bits_of(object));
  columns.add_integers("faces", flat_bits<Face>(mesh.faces()), 3);
  columns.add_integers("rods", flat_bits<Edge>(rods_of(mesh)), 2);
  columns.add_integers("loose_points", loose, 1);
  columns.add_integers("object_of_vertex", objects, 1);
  header["mesh"] = {{"vertices", mesh.vertex_count()},
                    {"faces", mesh.faces().size()},
                    {"edges", mesh.edges().size()},
                    {"points", mesh.points().size()},
                    {"names", shown.names}};
}

/// Every frame after the first as its difference from the one before.
void add_frames(const Recording& recording, Columns& columns, Json& header) {
  QuantisedFrames quantised = quantise(recording);
  for (std::size_t f = quantised.frames.size() - 1; f > 0; --f)
    for (std::size_t i = 0; i < quantised.frames[f].size(); ++i) quantised.frames[f][i] -= quantised.frames[f - 1][i];
  const auto write = [&](std::string& bytes) {
    for (const auto& frame : quantised.frames) append_differences(bytes, frame, 3);
  };
  columns.add("positions", quantised.frames.size() * quantised.frames.front().size(), write);
  header["grid"] = {{"lowest", quantised.lowest}, {"spacing", quantised.spacing}, {"error", quantised.error}};
}

/// A weight in [0,1] in 16 bits, rounded to nearest.
std::uint16_t fraction(double x) {
  constexpr double kLargest = 65535;
  return static_cast<std::uint16_t>(std::lround(std::clamp(x, 0.0, 1.0) * kLargest));
}

/// A component of a unit vector in 16 bits, rounded to nearest.
std::uint16_t component(double x) {
  constexpr double kLargest = 32767;
  return static_cast<std::uint16_t>(static_cast<std::int16_t>(std::lround(std::clamp(x, -1.0, 1.0) * kLargest)));
}

/// The pairs that are shown, a column a property.
class PairColumns {
 public:
  /// `width`: vertices of the kind that has most.
  explicit PairColumns(std::size_t width) : vertex_width_(width) {}

  void mark(bool is_new) { is_new_.push_back(is_new ? 1 : 0); }

  void add(const Contact& c) {
    for (const Index v : c.vertices) vertices_.push_back(bits_of(v));
    for (const double w : {c.u, c.v}) weights_.push_back(fraction(w));
    add(static_cast<std::uint8_t>(c.kind), c.certainty, {c.toi_lower, c.toi_upper}, c.normal);
  }
  /// `kind`: its number; `time`: at which time of the step the edge passes through the face.
  void add(const Intersection& i, const Point& normal, std::uint8_t kind, double time) {
    for (const Index v : i.edge) vertices_.push_back(bits_of(v));
    for (const Index v : i.face) vertices_.push_back(bits_of(v));
    for (const double w : {i.s_upper, i.u, i.v}) weights_.push_back(fraction(w));
    add(kind, Certainty::certified, {time, time}, normal);
  }
  void write(Columns& columns) const {
    columns.add_planes("kind", kinds_);
    columns.add_planes("certainty", certainties_);
    columns.add_integers("vertices", vertices_, vertex_width_);
    columns.add_planes("toi_lower", lower_);
    columns.add_planes("toi_width", width_);
    columns.add_planes("weights", weights_);
    columns.add_planes("normals", normals_);
    if (!is_new_.empty()) columns.add_planes("is_new", is_new_);
  }

 private:
  void add(std::uint8_t kind, Certainty certainty, std::array<double, 2> bracket, const Point& normal) {
    kinds_.push_back(kind);
    vertices_.resize(vertex_width_ * kinds_.size(), bits_of(-1));
    weights_.resize((vertex_width_ - 2) * kinds_.size(), 0);
    certainties_.push_back(static_cast<std::uint8_t>(certainty));
    // Doubles in [0,1] are ordered as their bits: the width in units in the last place is small if the bracket is
    // narrow.
    lower_.push_back(std::bit_cast<std::uint64_t>(bracket[0]));
    width_.push_back(std::bit_cast<std::uint64_t>(bracket[1]) - lower_.back());
    for (const double x : normal) normals_.push_back(component(x));
  }

  std::size_t vertex_width_;
  std::vector<std::uint8_t> kinds_, certainties_, is_new_;
  std::vector<std::uint32_t> vertices_;
  std::vector<std::uint64_t> lower_, width_;
  std::vector<std::uint16_t> weights_, normals_;
};

/// The number of edge-face among the kinds of an audit: after those of contacts.
constexpr std::uint8_t kEdgeFaceOfAudit = 4;

/// The page lists a step's contacts before its intersections.
void mark_new(const RecordedStep& step, PairColumns& pairs) {
  const std::size_t first = step.intersections.size();
  for (std::size_t i = first; i < step.is_new.size(); ++i) pairs.mark(step.is_new[i]);
  for (std::size_t i = 0; i < std::min(first, step.is_new.size()); ++i) pairs.mark(step.is_new[i]);
}

void add_pairs(const Recording& recording, Columns& columns) {
  PairColumns pairs(recording.pose || recording.strip ? 5 : 4);
  for (const RecordedStep& step : recording.steps) {
    for (const Contact& c : step.contacts) pairs.add(c);
    for (const Intersection& i : step.intersections)
      pairs.add(i, face_normal(i.face, recording.frames[step.ends->at(1)]), kEdgeFaceOfAudit, 1);
    mark_new(step, pairs);
  }
  if (recording.pose)
    for (const Intersection& i : recording.pose->intersections)
      pairs.add(i, face_normal(i.face, recording.frames.front()), 0, 0);
  pairs.write(columns);
}

/// The kinds of pair, in the order of their numbers.
Json kinds(const Recording& recording) {
  const Json edge_face{{"name", "ef"}, {"first", 2}, {"second", 3}};
  if (recording.pose) return Json::array({edge_face});
  Json kinds = Json::array();
  for (const PairKind kind :
       {PairKind::vertex_face, PairKind::edge_edge, PairKind::vertex_edge, PairKind::vertex_vertex}) {
    const PairShape shape = shape_of(kind);
    kinds.push_back({{"name", name_of(kind)}, {"first", shape.first}, {"second", shape.second}});
  }
  if (recording.strip) kinds.push_back(edge_face);
  return kinds;
}

Json json_of(const RecordedStep& step) {
  const Tally tally = tally_of(step.contacts);
  Json json{{"contacts", json_of(tally)}};
  json["contacts"]["unresolved"] = tally.unresolved;
  if (step.ends) {
    json["contacts"]["ef"] = step.intersections.size();
    json["ends"] = *step.ends;
  }
  json["complete"] = !step.free_before;
  json["ignored"] = step.ignored;
  if (step.collapsed.empty()) {
    const bool is_free = !step.free_before && tally.is_free();
    add_bracket(json, is_free, step.free_before.value_or(tally.toi_lower), tally.toi_upper);
  } else {
    json["collapsed"] = step.collapsed;
    add_bracket(json, false, 0, tally.toi_upper);
  }
  add_stages(json, step.stages);
  return json;
}

/// The pose as a step that stands still.
Json json_of(const RecordedPose& pose) {
  Json json{{"contacts", {{"ef", pose.intersections.size()}, {"unresolved", 0}}}, {"complete", true}, {"ignored", 0}};
  if (!pose.collapsed.empty()) json["collapsed"] = pose.collapsed;
  add_bracket(json, pose.intersections.empty() && pose.collapsed.empty(), 0, 0);
  add_stages(json, pose.stages);
  return json;
}

Json json_of(const RecordedStrip& strip) {
  Json problems = Json::object();
  for (std::size_t frame = 0; frame < strip.problems.size(); ++frame)
    if (!strip.problems[frame].empty()) problems[std::to_string(frame)] = strip.problems[frame];
  return {{"asks_intersections", strip.asks_intersections},
          {"names", strip.names},
          {"problems", std::move(problems)},
          {"has_step", strip.has_step},
          {"contacts", strip.contacts},
          {"intersections", strip.intersections},
          {"fresh", strip.fresh},
          {"collapsed", strip.collapsed},
          {"steps", strip.steps}};
}

}  // namespace

std::string scene_bytes(const Recording& recording) {
  Json header{{"names", recording.names},
              {"scale", recording.scale},
              {"min_separation", recording.options.min_separation},
              {"at_start", name_of(recording.at_start)},
              {"kinds", kinds(recording)},
              {"steps", Json::array()}};
  for (const RecordedStep& step : recording.steps) header["steps"].push_back(json_of(step));
  if (recording.pose) header["steps"].push_back(json_of(*recording.pose));
  if (recording.strip) header["strip"] = json_of(*recording.strip);
  Columns columns;
  add_mesh(recording, columns, header);
  add_frames(recording, columns, header);
  add_pairs(recording, columns);
  header["columns"] = columns.list();
  // Names of files may hold any byte, JSON may not.
  const std::string text = header.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string bytes;
  for (std::size_t byte = 0; byte < sizeof(std::uint32_t); ++byte)
    bytes += static_cast<char>((text.size() >> (8 * byte)) & 0xff);
  return bytes + text + columns.bytes();
}

}  // namespace tamis::io
