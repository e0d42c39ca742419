#include <algorithm>
#include <nlohmann/json.hpp>

#include "io/error.hpp"
#include "lab/queries/queries.hpp"

namespace tamis::lab {
namespace {

/// Without the order of its keys (io/output/json.hpp), so that many of them cost no more than their number times its
/// logarithm.
using KeyedJson = nlohmann::json;

/// A query takes a thousand bytes and four levels.
constexpr std::size_t kMostBytes = std::size_t{4} << 20;
constexpr int kDeepest = 64;

/// How many arrays and objects lie within each other at most; text in quotes does not count.
int depth_of(std::string_view json) {
  int depth = 0, deepest = 0;
  bool in_quotes = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (c == '"')
      in_quotes = !in_quotes;
    else if (in_quotes)
      i += c == '\\' ? 1 : 0;
    else if (c == '{' || c == '[')
      deepest = std::max(deepest, ++depth);
    else if (c == '}' || c == ']')
      --depth;
  }
  return deepest;
}

class RigidParser {
 public:
  RigidParser(std::string_view bytes, const std::string& name) : name_(name) {
    if (bytes.size() > kMostBytes)
      fail("", fmt::format("is {} bytes long: a query takes no more than {}", bytes.size(), kMostBytes));
    if (depth_of(bytes) > kDeepest) fail("", fmt::format("nests deeper than {} levels: a query takes four", kDeepest));
    root_ = KeyedJson::parse(bytes, nullptr, false);
    if (root_.is_discarded()) fail("", "is no JSON: write the file again");
  }

  RigidQuery parse() const {
    const KeyedJson& type = member(root_, "type", "");
    if (type != "fv" && type != "ee") fail("type", "is neither fv nor ee: correct it");
    RigidQuery query{};
    query.kind = type == "fv" ? PairKind::vertex_face : PairKind::edge_edge;
    if (query.kind == PairKind::vertex_face) {
      take(query, 0, "vertex", {"vertex"}, 0);
      take(query, 1, "face", {"vertex0", "vertex1", "vertex2"}, 1);
    } else {
      take(query, 0, "edge0", {"vertex0", "vertex1"}, 0);
      take(query, 2, "edge1", {"vertex0", "vertex1"}, 1);
    }
    return query;
  }

 private:
  void take(RigidQuery& query, std::size_t first, const char* feature, std::initializer_list<const char*> corners,
            std::size_t body) const {
    const KeyedJson& json = member(root_, feature, "");
    for (const char* corner : corners) query.points[first++] = point(json, corner, feature);
    query.bodies[body] = {pose(json, "pose_t0", feature), pose(json, "pose_t1", feature)};
  }

  Pose pose(const KeyedJson& feature, const char* key, const std::string& above) const {
    const KeyedJson& json = member(feature, key, above);
    return {point(json, "position", above + "." + key), point(json, "rotation", above + "." + key)};
  }

  Point point(const KeyedJson& object, const char* key, const std::string& above) const {
    const KeyedJson& json = member(object, key, above);
    const std::string place = above + "." + key;
    if (!json.is_array() || json.size() != 3) fail(place, "is no array of three numbers: give x, y and z");
    Point point{};
    for (std::size_t k = 0; k < 3; ++k) {
      if (!json[k].is_number()) fail(place, "holds something that is no number: give x, y and z");
      point[k] = json[k].get<double>();
      if (!(point[k] - point[k] == 0)) fail(place, "holds a number beyond all doubles: correct it");
    }
    return point;
  }

  const KeyedJson& member(const KeyedJson& object, const char* key, const std::string& above) const {
    if (!object.is_object() || !object.contains(key))
      fail(above.empty() ? key : above + "." + key, "is missing: add it");
    return object[key];
  }

  [[noreturn]] void fail(const std::string& where, const std::string& what) const {
    throw io::FileError(name_, where, what);
  }

  KeyedJson root_;
  const std::string& name_;
};

}  // namespace

RigidPath RigidQuery::path() const {
  const Index other_from = kind == PairKind::vertex_face ? 1 : 2;
  std::vector<Index> body_of_vertex;
  for (Index v = 0; v < 4; ++v) body_of_vertex.push_back(v < other_from ? 0 : 1);
  return {{points.begin(), points.end()}, std::move(body_of_vertex), {{bodies[0]}, {bodies[1]}}};
}

RigidQuery parse_rigid_query(std::string_view bytes, const std::string& name) {
  return RigidParser(bytes, name).parse();
}

}  // namespace tamis::lab
