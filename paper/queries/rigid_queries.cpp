#include <initializer_list>

#include "files/error.hpp"
#include "files/json_file.hpp"
#include "paper/queries/queries.hpp"

namespace tamis::lab {
namespace {

/// Far more than a query takes, which is about a thousand bytes.
constexpr std::size_t kMostBytes = std::size_t{4} << 20;

Pose pose_of(const io::JsonValue& json) { return {json.member("position").point(), json.member("rotation").point()}; }

void take(RigidQuery& query, std::size_t first, const io::JsonValue& feature,
          std::initializer_list<const char*> corners, std::size_t body) {
  for (const char* corner : corners) query.points[first++] = feature.member(corner).point();
  query.bodies[body] = {pose_of(feature.member("pose_t0")), pose_of(feature.member("pose_t1"))};
}

}  // namespace

RigidPath RigidQuery::path() const {
  const Index other_from = kind == PairKind::vertex_face ? 1 : 2;
  std::vector<Index> body_of_vertex;
  for (Index v = 0; v < 4; ++v) body_of_vertex.push_back(v < other_from ? 0 : 1);
  return {{points.begin(), points.end()}, std::move(body_of_vertex), {{bodies[0]}, {bodies[1]}}};
}

RigidQuery parse_rigid_query(std::string_view bytes, const std::string& name) {
  if (bytes.size() > kMostBytes)
    throw io::FileError(name, "",
                        fmt::format("is {} bytes long: a query takes no more than {}", bytes.size(), kMostBytes));
  const io::JsonFile file(bytes, name);
  const io::JsonValue root = file.root(), type = root.member("type");
  const bool is_face = type.is_text() && type.text() == "fv";
  if (!is_face && !(type.is_text() && type.text() == "ee")) type.fail("is neither fv nor ee: correct it");
  RigidQuery query{};
  query.kind = is_face ? PairKind::vertex_face : PairKind::edge_edge;
  if (is_face) {
    take(query, 0, root.member("vertex"), {"vertex"}, 0);
    take(query, 1, root.member("face"), {"vertex0", "vertex1", "vertex2"}, 1);
  } else {
    take(query, 0, root.member("edge0"), {"vertex0", "vertex1"}, 0);
    take(query, 2, root.member("edge1"), {"vertex0", "vertex1"}, 1);
  }
  return query;
}

}  // namespace tamis::lab
