#include "files/bodies/bodies_file.hpp"

#include <map>

#include "files/error.hpp"
#include "files/file_bytes.hpp"
#include "files/json_file.hpp"
#include "files/mesh/frames.hpp"
#include "files/system.hpp"
#include "numbers/floating_point_state.hpp"

namespace tamis::io {
namespace {

using Body = BodiesFile::Body;

/// Returns ask(). An Error that it throws becomes a FileError that names `place`.
template <class Ask>
auto said_of(const JsonValue& place, const Ask& ask) {
  try {
    return ask();
  } catch (const Error& error) {
    place.fail(error.what());
  }
}

template <std::size_t count>
std::vector<std::array<Index, count>> index_rows(const JsonValue& json, const char* what) {
  std::vector<std::array<Index, count>> rows;
  for (const JsonValue& row : json.items(what)) {
    const std::vector<JsonValue> vertices = row.items(what);
    if (vertices.size() != count) row.fail(fmt::format("has {} vertices: give {}", vertices.size(), what));
    for (std::size_t k = 0; auto& vertex : rows.emplace_back()) vertex = vertices[k++].index();
  }
  return rows;
}

MeshFile embedded_mesh(const JsonValue& json) {
  json.allow_only({"points", "faces", "edges", "loose_points"});
  MeshFile mesh;
  for (const JsonValue& point : json.member("points").items("a list of [x, y, z]"))
    mesh.positions.push_back(point.point());
  if (const auto faces = json.find("faces"))
    mesh.faces = index_rows<3>(*faces, "a list of triangles, three vertices each");
  if (const auto edges = json.find("edges"))
    mesh.loose_edges = index_rows<2>(*edges, "a list of loose edges, two vertices each");
  if (const auto points = json.find("loose_points"))
    for (const JsonValue& point : points->items("a list of vertices")) mesh.loose_points.push_back(point.index());
  said_of(json, [&] { return mesh_of(mesh); });
  return mesh;
}

Pose pose_from(const JsonValue& json) {
  json.allow_only({"position", "rotation", "quaternion"});
  const auto position = json.find("position"), rotation = json.find("rotation"), quaternion = json.find("quaternion");
  if (rotation && quaternion) json.fail("has a rotation and a quaternion: give one of them");
  const Point at = position ? position->point() : Point{0, 0, 0};
  if (!quaternion) return {at, rotation ? rotation->point() : Point{0, 0, 0}};
  const std::vector<double> q = quaternion->numbers(4, "w, x, y and z");
  return said_of(*quaternion, [&] { return pose_of_quaternion({q[0], q[1], q[2], q[3]}, at); });
}

class Parser {
 public:
  Parser(const std::filesystem::path& path, const JsonValue& root) : folder_(path.parent_path()), root_(root) {}

  BodiesFile parse() {
    root_.allow_only({"meshes", "bodies", "may_not_touch"});
    const JsonValue bodies = root_.member("bodies");
    for (const JsonValue& json : bodies.items("a list of bodies, as {\"mesh\": \"floor.ply\"}")) add_body(json);
    if (const auto meshes = root_.find("meshes"))
      for (const std::string& name : meshes->keys())
        if (!mesh_places_.contains(name)) meshes->member(name).fail("no body has this mesh: remove it");
    if (file_.frame_count == 0)
      bodies.fail("no body moves: give at least one 'poses' or 'frames', two or more of them");
    if (const auto pairs = root_.find("may_not_touch")) add_pairs(*pairs);
    return std::move(file_);
  }

 private:
  void add_body(const JsonValue& json) {
    json.allow_only({"name", "mesh", "pose", "poses", "turn", "frames"});
    Body body;
    body.name = json.has("name") ? json.member("name").text() : fmt::format("body {}", file_.bodies.size());
    if (!body_places_.emplace(body.name, file_.bodies.size()).second)
      json.fail(fmt::format("another body is called {}, too: give each a name of its own", in_quotes(body.name)));
    const int ways = json.has("pose") + json.has("poses") + json.has("frames");
    if (ways > 1) json.fail("has several of 'pose', 'poses' and 'frames': a body stays, moves as a whole, or deforms");
    if (json.has("turn") && !json.has("poses")) json.member("turn").fail("is of bodies with 'poses' alone: remove it");
    if (const auto frames = json.find("frames")) {
      if (json.has("mesh")) json.fail("has a mesh and frames: frames are meshes, remove 'mesh'");
      body.frames = frame_paths(*frames);
      count_frames(*frames, body.frames.size());
    } else {
      body.mesh = mesh_place(json.member("mesh"));
      take_poses(json, body);
    }
    file_.bodies.push_back(std::move(body));
  }

  void take_poses(const JsonValue& json, Body& body) {
    const auto poses = json.find("poses");
    if (!poses) {
      body.poses = {json.has("pose") ? pose_from(json.member("pose")) : Pose{}};
      return;
    }
    const auto turn = json.find("turn");
    body.turns_linearly = turn && turn->text() == "linear";
    if (turn && !body.turns_linearly && turn->text() != "shorter")
      turn->fail("is neither shorter nor linear: correct it");
    for (const JsonValue& pose : poses->items("a list of poses, one a frame")) {
      if (body.turns_linearly && pose.has("quaternion"))
        pose.fail("turn 'linear' is of rotation vectors: give 'rotation' instead of 'quaternion'");
      body.poses.push_back(pose_from(pose));
    }
    count_frames(*poses, body.poses.size());
  }

  /// All bodies that move must have the same number of frames.
  void count_frames(const JsonValue& place, std::size_t count) {
    if (count < 2) place.fail(fmt::format("has {}: a body that moves has two or more, one a frame", count));
    if (file_.frame_count == 0) file_.frame_count = count;
    if (count != file_.frame_count)
      place.fail(fmt::format("has {}, but a body above has {}: give as many, one a frame", count, file_.frame_count));
  }

  std::vector<std::string> frame_paths(const JsonValue& json) const {
    std::vector<std::string> names, paths;
    for (const JsonValue& name : json.items("a list of mesh files, folders or patterns")) names.push_back(name.text());
    if (has_own_order(names, folder_)) json.fail("frames are taken in natural order, 2 before 10: list them in it");
    if (names.empty()) json.fail("has no frame: name two mesh files or more");
    for (const auto& path : said_of(json, [&] { return moving_files(names, folder_); })) paths.push_back(path.string());
    return paths;
  }

  /// The place of a mesh by its name: a key of "meshes", otherwise a file. Each mesh is read once.
  std::size_t mesh_place(const JsonValue& json) {
    const std::string name = json.text();
    const auto [known, is_new] = mesh_places_.emplace(name, file_.meshes.size());
    if (!is_new) return known->second;
    const auto meshes = root_.find("meshes");
    if (const auto embedded = meshes ? meshes->find(name) : std::nullopt) {
      file_.meshes.push_back({name, embedded_mesh(*embedded)});
    } else {
      const std::filesystem::path path = folder_ / system::path_of(name);
      file_.meshes.push_back({path.string(), said_of(json, [&] { return read_mesh(path); })});
    }
    return known->second;
  }

  void add_pairs(const JsonValue& json) {
    const char* const what = "a list of pairs of bodies, as [\"floor\", \"wall\"]";
    for (const JsonValue& pair : json.items(what)) {
      const std::vector<JsonValue> names = pair.items(what);
      if (names.size() != 2) pair.fail(fmt::format("has {} names: give two", names.size()));
      file_.may_not_touch.push_back({body_place(names[0]), body_place(names[1])});
    }
  }

  std::size_t body_place(const JsonValue& name) const {
    const auto found = body_places_.find(name.text());
    if (found == body_places_.end()) name.fail(fmt::format("no body is called {}: correct it", in_quotes(name.text())));
    return found->second;
  }

  std::filesystem::path folder_;
  JsonValue root_;
  BodiesFile file_;
  std::map<std::string, std::size_t> body_places_, mesh_places_;
};

}  // namespace

BodiesFile read_bodies(const std::filesystem::path& path) {
  const ComputingState state;
  const FileBytes bytes(path);
  const JsonFile json(bytes.view(), path.string());
  return Parser(path, json.root()).parse();
}

}  // namespace tamis::io
