// tamis scene: simulates one of the simulated scenes into a folder of frames.
#include <fmt/format.h>

#include <memory>
#include <string>

#include "command/command_line/arguments.hpp"
#include "command/command_line/messages.hpp"
#include "command/command_line/printable.hpp"
#include "command/command_line/verb.hpp"
#include "command/progress.hpp"
#include "files/mesh/mesh_file.hpp"
#include "scenes/simulation/recording.hpp"
#include "tamis/detector.hpp"

namespace tamis::cli {
namespace {

class Scene final : public Verb {
 public:
  const char* name() const override { return "scene"; }
  const char* summary() const override { return "Simulates airbag, cloth-ball, funnel or bunny into frames"; }
  const char* examples() const override {
    return "  tamis scene cloth-ball --out frames\n"
           "  tamis scene funnel --triangles 92000 --out frames\n"
           "  tamis scene bunny --out frames --check\n"
           "  tamis scene airbag --triangles 4000 --frames 30 --seed 7 --out frames\n\n"
           "Frames are frame_0000.ply, frame_0001.ply, ...: binary PLY in doubles, free of intersections. The same\n"
           "command continues an interrupted run.";
  }
  void declare(OptionList& options) override {
    std::string names;
    for (const auto& scene : simulation::simulated_scenes())
      names += fmt::format("{}{}: {}", names.empty() ? "" : "; ", scene.name, scene.description);
    options.add_text("NAME", scene_, names).required();
    options.add_path("--out", folder_, "the folder of the frames; made if it is not there")
        .shown_as("FOLDER")
        .required();
    options.add_number("--frames", "N", frames_, {0, 9999}, "frames after the first; default: the whole scene");
    options.add_number("--triangles", "N", triangles_, {kLeastTriangles, kMostTriangles},
                       "about so many, obstacles included; default: the scene's full size");
    options.add_flag("--check", check_,
                     "then read every frame and prove it free of intersections; exit code 1 if one is not");
    declare_seed(options, seed_, "the small disorder at the start");
  }

  int run() override {
    const simulation::SimulatedScene& scene = simulation::simulated_scene(scene_);
    const int frames = frames_ < 0 ? scene.frames : frames_;
    Progress progress(static_cast<std::size_t>(frames), "frames");
    simulation::Effort sum;
    simulation::record(scene, {folder_, frames, triangles_ < 0 ? scene.triangles : triangles_, seed_},
                       [&](const simulation::Simulator& simulator) {
                         sum += simulator.effort();
                         progress.show(static_cast<std::size_t>(simulator.frame()));
                       });
    progress.clear();
    fmt::print("scene           {}, {} frames after the first in {}\n", scene.name, frames,
               printable(folder_.string()));
    fmt::print("substeps        {} now, each proven free of contacts\n", sum.substeps);
    fmt::print("constraints     {} contacts, {} rounds of repair, {} vertices in impact zones\n", sum.touches,
               sum.repairs, sum.zone_vertices);
    return check_ ? check(frames) : kSuccess;
  }

 private:
  /// Checks the files, not the simulator's memory, and without the simulator's pair filter.
  int check(int frames) const {
    Progress progress(static_cast<std::size_t>(frames), "frames checked");
    int intersecting = 0;
    for (int i = 0; i <= frames; ++i) {
      const io::MeshFile frame = io::read_mesh(simulation::frame_path(folder_, i));
      Detector detector(io::mesh_of(frame));
      const auto& found = detector.intersections(frame.positions);
      if (!found.empty()) {
        ++intersecting;
        const Face& face = found.front().face;
        note(fmt::format("{}: {} intersections, the first with the face {} {} {}",
                         simulation::frame_path(folder_, i).string(), found.size(), face[0], face[1], face[2]));
      }
      progress.show(static_cast<std::size_t>(i));
    }
    progress.clear();
    fmt::print("checked         {} frames, {} with intersections\n", frames + 1, intersecting);
    return intersecting == 0 ? kSuccess : kNo;
  }

  static constexpr int kLeastTriangles = 500;
  static constexpr int kMostTriangles = 10'000'000;

  std::string scene_;
  std::filesystem::path folder_;
  int frames_ = -1;
  int triangles_ = -1;
  std::uint64_t seed_ = 1;
  bool check_ = false;
};

}  // namespace

std::unique_ptr<Verb> make_scene() { return std::make_unique<Scene>(); }

}  // namespace tamis::cli
