#include "cli/verbs/moving_bodies.hpp"

#include <algorithm>
#include <optional>

#include "cli/command_line/messages.hpp"
#include "io/error.hpp"

namespace tamis::cli {

MovingBodies::MovingBodies(const std::filesystem::path& path) : path_(path), file_(io::read_bodies(path)) {
  for (const auto& [name, mesh] : file_.meshes)
    for (const std::string& sentence : mesh.notes) note(fmt::format("{}: {}", name, sentence));
  for (std::size_t i = 0; i < file_.bodies.size(); ++i) {
    const auto& body = file_.bodies[i];
    names_.push_back(body.name);
    if (body.frames.empty()) continue;
    MovingFrames frames(body.frames);
    std::vector<Point> first = frames.first().positions;
    deforming_.emplace(i, Deforming{std::move(frames), std::move(first)});
  }
}

std::vector<std::filesystem::path> MovingBodies::inputs() const {
  std::vector<std::filesystem::path> inputs{path_};
  for (const auto& mesh : file_.meshes) inputs.emplace_back(mesh.name);
  for (const auto& body : file_.bodies) inputs.insert(inputs.end(), body.frames.begin(), body.frames.end());
  return inputs;
}

std::size_t MovingBodies::count_of(bool moves, bool deforms) const {
  return static_cast<std::size_t>(std::count_if(file_.bodies.begin(), file_.bodies.end(), [&](const auto& body) {
    return body.moves() == moves && !body.frames.empty() == deforms;
  }));
}

std::size_t MovingBodies::triangles_of(std::size_t body) const {
  const auto deforming = deforming_.find(body);
  return (deforming == deforming_.end() ? file_.meshes[file_.bodies[body].mesh].mesh : deforming->second.frames.first())
      .faces.size();
}

std::size_t MovingBodies::triangle_count() const {
  std::size_t count = 0;
  for (std::size_t i = 0; i < file_.bodies.size(); ++i) count += triangles_of(i);
  return count;
}

World MovingBodies::world(const Options& options) {
  const auto shape_of = [](const io::MeshFile& mesh) { return Shape(io::mesh_of(mesh), mesh.positions); };
  std::vector<Shape> shapes;
  for (const auto& mesh : file_.meshes) shapes.push_back(shape_of(mesh.mesh));
  World world(options);
  for (std::size_t i = 0; i < file_.bodies.size(); ++i) {
    const auto deforming = deforming_.find(i);
    world.add(deforming == deforming_.end() ? shapes[file_.bodies[i].mesh] : shape_of(deforming->second.frames.first()),
              motion_of(i, 1));
  }
  for (const auto& [a, b] : file_.may_not_touch)
    world.set_may_touch(static_cast<BodyId>(a), static_cast<BodyId>(b), false);
  return world;
}

void MovingBodies::go_on(World& world, std::size_t step) {
  for (std::size_t i = 0; i < file_.bodies.size(); ++i)
    if (file_.bodies[i].moves()) world.move(static_cast<BodyId>(i), motion_of(i, step));
}

BodyMotion MovingBodies::motion_of(std::size_t body, std::size_t step) {
  const auto& [name, mesh, poses, turns_linearly, frames] = file_.bodies[body];
  if (poses.size() == 1) return Static{poses.front()};
  if (!poses.empty()) return Rigid{(turns_linearly ? interpolated : between)(poses[step - 1], poses[step])};
  auto& deforming = deforming_.at(body);
  std::vector<Point> start = std::exchange(deforming.last, deforming.frames.read(step));
  return tamis::Deforming{std::move(start), deforming.last};
}

}  // namespace tamis::cli
