#include "scenes/simulation/recording.hpp"

#include <fmt/format.h>

#include <cstring>

#include "files/atomic_file.hpp"
#include "files/file_bytes.hpp"
#include "files/mesh/ply.hpp"
#include "files/text.hpp"
#include "tamis/error.hpp"

namespace tamis::simulation {
namespace {

std::filesystem::path state_path(const std::filesystem::path& folder) { return folder / "state.bin"; }

/// First line of the state: everything that decides the run, except how far it goes.
std::string title(const SimulatedScene& scene, const Recording& recording, const Particles& particles) {
  return fmt::format("tamis scene {} triangles {} seed {} particles {}", scene.name, recording.triangles,
                     recording.seed, particles.count());
}

std::string_view bytes_of(const Points& points) {
  return {reinterpret_cast<const char*>(points.data()), static_cast<std::size_t>(points.size()) * sizeof(double)};
}

Points points_from(std::string_view bytes) {
  Points points(3, static_cast<Eigen::Index>(bytes.size() / (3 * sizeof(double))));
  std::memcpy(points.data(), bytes.data(), bytes.size());
  return points;
}

void write_frame(const std::filesystem::path& folder, const Simulator& simulator) {
  io::MeshFile mesh;
  const Points& x = simulator.particles().position;
  for (Index v = 0; v < simulator.model().mesh_vertices(); ++v) mesh.positions.push_back({x(0, v), x(1, v), x(2, v)});
  mesh.faces = simulator.model().faces;
  io::write_ply(frame_path(folder, simulator.frame()), mesh);
}

/// The title, the number of the frame, then positions and velocities in this machine's doubles.
void write_state(const std::filesystem::path& folder, const std::string& name, const Simulator& simulator) {
  io::AtomicFile file(state_path(folder));
  file.append(fmt::format("{}\n{}\n", name, simulator.frame()));
  file.append(bytes_of(simulator.particles().position));
  file.append(bytes_of(simulator.particles().velocity));
  file.commit();
}

void resume(const std::filesystem::path& folder, const std::string& name, Simulator& simulator) {
  const std::string file = state_path(folder).string();
  const io::FileBytes bytes(file);
  io::Lines lines(bytes.view());
  if (!lines.next() || lines.line() != name)
    throw Error(file + " belongs to another run (" + std::string(lines.line()) + "): choose another folder");
  const auto frame = lines.next() ? io::to_integer<int>(lines.line()) : std::nullopt;
  const std::string_view body = lines.rest();
  if (!frame || body.size() != 2 * bytes_of(simulator.particles().position).size())
    throw Error(file + " is damaged: remove it to start anew");
  simulator.resume(*frame, points_from(body.substr(0, body.size() / 2)), points_from(body.substr(body.size() / 2)));
}

/// Refuses to overwrite frames of another run. Writes a state before frame 1 is made: otherwise, after an interruption,
/// the run would take its own frame 1 for another run's.
void begin(const std::filesystem::path& folder, const std::string& name, const Simulator& simulator) {
  const std::filesystem::path other = frame_path(folder, 1);
  if (std::filesystem::exists(other))
    throw Error(other.string() + " is there, but no " + state_path(folder).string() +
                " to continue from: choose another folder, or remove its frames");
  write_frame(folder, simulator);
  write_state(folder, name, simulator);
}

}  // namespace

std::filesystem::path frame_path(const std::filesystem::path& folder, int frame) {
  return folder / fmt::format("frame_{:04}.ply", frame);
}

void record(const SimulatedScene& scene, const Recording& recording, const FrameMade& made) {
  io::make_folder(recording.folder);
  Simulator simulator(scene.make(recording.triangles, recording.seed));
  const std::string name = title(scene, recording, simulator.particles());
  if (std::filesystem::exists(state_path(recording.folder)))
    resume(recording.folder, name, simulator);
  else
    begin(recording.folder, name, simulator);
  while (simulator.frame() < recording.frames) {
    simulator.advance();
    write_frame(recording.folder, simulator);
    write_state(recording.folder, name, simulator);
    made(simulator);
  }
}

}  // namespace tamis::simulation
