#include "command/verbs/bodies/moving_bodies.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "command/command_line/messages.hpp"
#include "files/system.hpp"

namespace tamis::cli {

MovingBodies::MovingBodies(const std::filesystem::path& path) : path_(path), file_(io::read_bodies(path)) {
  for (const auto& [name, mesh] : file_.meshes)
    for (const std::string& sentence : mesh.notes) note(fmt::format("{}: {}", name, sentence));
  for (std::size_t i = 0; i < file_.bodies.size(); ++i) {
    const auto& body = file_.bodies[i];
    names_.push_back(body.name);
    if (!body.frames.empty()) frames_.emplace(i, MovingFrames(body.frames)).first->second.require_no_gap();
    motions_.push_back(motion_from(i, body.frames.empty() ? std::vector<Point>() : mesh_of(i).positions));
  }
  for (const auto& [i, frames] : frames_)
    collapse_.emplace(i, CollapseCheck(meshes_.emplace(i, io::mesh_of(frames.first())).first->second));
}

void MovingBodies::leave_out_collapsed(World& world) {
  leaves_out_ = false;
  for (auto& [i, collapse] : collapse_) {
    const auto& paths = frames_.at(i).paths();
    const auto& motion = std::get<Deforming>(motions_[i]);
    collapse.clear();
    collapse.look(paths[step_ - 1].string(), motion.start);
    collapse.look(paths[step_].string(), motion.end);
    world.set_enabled(static_cast<BodyId>(i), collapse.passes());
    leaves_out_ = leaves_out_ || !collapse.passes();
  }
}

std::size_t MovingBodies::count_of(bool moves, bool deforms) const {
  return static_cast<std::size_t>(std::count_if(file_.bodies.begin(), file_.bodies.end(), [&](const auto& body) {
    return body.moves() == moves && !body.frames.empty() == deforms;
  }));
}

std::size_t MovingBodies::triangle_count() const {
  std::size_t triangles = 0;
  for (std::size_t i = 0; i < count(); ++i) triangles += mesh_of(i).faces.size();
  return triangles;
}

const io::MeshFile& MovingBodies::mesh_of(std::size_t body) const {
  const auto frames = frames_.find(body);
  return frames == frames_.end() ? file_.meshes[file_.bodies[body].mesh].mesh : frames->second.first();
}

std::vector<std::filesystem::path> MovingBodies::inputs() const {
  std::vector<std::filesystem::path> inputs{path_};
  for (const auto& mesh : file_.meshes) inputs.push_back(system::path_of(mesh.name));
  for (const auto& body : file_.bodies)
    for (const std::string& frame : body.frames) inputs.push_back(system::path_of(frame));
  return inputs;
}

World MovingBodies::world(const Options& options) const {
  const auto shape_of = [&](const io::MeshFile& mesh) { return Shape(io::mesh_of(mesh), mesh.positions, options.isa); };
  std::vector<Shape> shapes;
  for (const auto& mesh : file_.meshes) shapes.push_back(shape_of(mesh.mesh));
  World world(options);
  for (std::size_t i = 0; i < count(); ++i)
    world.add(frames_.contains(i) ? shape_of(mesh_of(i)) : shapes[file_.bodies[i].mesh], motions_[i]);
  for (const auto& [a, b] : file_.may_not_touch)
    world.set_may_touch(static_cast<BodyId>(a), static_cast<BodyId>(b), false);
  return world;
}

void MovingBodies::go_on(World& world) {
  ++step_;
  for (std::size_t i = 0; i < count(); ++i) {
    if (!file_.bodies[i].moves()) continue;
    const auto* deforming = std::get_if<Deforming>(&motions_[i]);
    motions_[i] = motion_from(i, deforming ? deforming->end : std::vector<Point>());
    world.move(static_cast<BodyId>(i), motions_[i]);
  }
}

BodyMotion MovingBodies::motion_from(std::size_t body, std::vector<Point> start) const {
  const auto& [name, mesh, poses, turns_linearly, frames] = file_.bodies[body];
  if (poses.size() == 1) return Static{poses.front()};
  if (!poses.empty()) {
    const Pose &from = poses[step_ - 1], &to = poses[step_];
    return Rigid{turns_linearly ? interpolated_chain(from, to) : chain_between(from, to)};
  }
  return Deforming{std::move(start), frames_.at(body).read(step_)};
}

}  // namespace tamis::cli
