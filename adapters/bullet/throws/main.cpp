// For each method of simulating: how many throws it lets through, how many are not proven free, and the cost of a step;
// the same for a pile and a cloth.
#include <fmt/core.h>

#include <CLI/CLI.hpp>

#include "adapters/bullet/throws/cloth.hpp"
#include "adapters/bullet/throws/frames.hpp"
#include "adapters/bullet/throws/independent.hpp"
#include "adapters/bullet/throws/pile.hpp"
#include "adapters/bullet/throws/scenes.hpp"

namespace tamis::bullet {
namespace {

void report(std::string_view title, const Scene& scene, int samples, const std::string& out) {
  fmt::print("{}: {} throws\n{:28} {:>9} {:>13} {:>16} {:>10}\n", title, scene.trials.size(), "", "through",
             "not proven", "sampled crossing", "ms a step");
  for (const Method method :
       {Method::hull, Method::hull_ccd, Method::mesh, Method::clamped_hull, Method::clamped_mesh}) {
    int through = 0, touching = 0, crossing = 0, steps = 0;
    double milliseconds = 0;
    for (const Trial& trial : scene.trials) {
      const Flight flight = trial.arena->fly(method, trial.thrown);
      if (!out.empty() && &trial == &scene.trials.front())
        write_frames(std::filesystem::path(out) / title, std::string(name_of(method)),
                     std::array{trial.arena->fixed(), trial.arena->flying()}, places_of(flight));
      through += trial.is_through(flight);
      touching += touching_steps(*trial.arena, flight) > 0;
      crossing += sampled_crossings(*trial.arena, flight, samples) > 0;
      steps += trial.thrown.steps;
      milliseconds += flight.milliseconds;
    }
    fmt::print("{:28} {:>9} {:>13} {:>16} {:>10.3f}\n", name_of(method), through, touching, crossing,
               milliseconds / steps);
  }
}

void report_pile(int plates, double drop, int steps, const std::string& out) {
  fmt::print("A pile of {} plates, {} steps\n{:28} {:>9} {:>13} {:>16} {:>10}\n", plates, steps, "", "inside",
             "not proven", "questions a step", "ms a step");
  for (const bool clamped : {false, true}) {
    const PileRun run = run_pile(plates, drop, steps, clamped);
    constexpr std::size_t kWithoutFloor = 1;
    if (!out.empty()) write_frames(out, clamped ? "clamped" : "bullet", run.bodies, run.places, kWithoutFloor);
    fmt::print("{:28} {:>9} {:>13} {:>16.2f} {:>10.3f}\n", clamped ? "clamped" : "Bullet", plates_inside(run),
               touching_steps(run.bodies, run.places), run.questions, run.milliseconds);
  }
}

void report_cloth(int side, int steps, const std::string& out) {
  fmt::print("A cloth of {0} x {0} vertices, {1} steps\n{2:28} {3:>9} {4:>10}\n", side, steps, "", "touching",
             "ms a step");
  for (const bool truncated : {false, true}) {
    const ClothRun run = run_cloth(side, steps, truncated);
    if (!out.empty()) write_frames(out, truncated ? "truncated" : "bullet", run.frames, run.mesh.faces());
    fmt::print("{:28} {:>9} {:>10.3f}\n", truncated ? "truncated" : "Bullet", touching_steps(run), run.milliseconds);
  }
}

}  // namespace
}  // namespace tamis::bullet

int main(int argc, char** argv) {
  CLI::App app("Throws bodies at meshes in Bullet, as it is and clamped; counts those that pass through");
  int count = 40, samples = 16;
  app.add_option("--throws", count, "of each kind")->check(CLI::Range(1, 100000))->capture_default_str();
  app.add_option("--samples", samples, "times in each step at which crossings are looked for")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  int plates = 0, side = 0, steps = 60;
  auto* const pile =
      app.add_option("--pile", plates, "no throws: a pile of so many thin plates")->check(CLI::Range(1, 1000));
  double drop = 0.0015;
  app.add_option("--drop", drop, "how far each plate of the pile is above the next at first, in metres")
      ->check(CLI::Range(1e-4, 100.0))
      ->needs(pile)
      ->capture_default_str();
  app.add_option("--cloth", side, "no throws: a cloth of so many vertices a side")
      ->check(CLI::Range(2, 1000))
      ->excludes(pile);
  app.add_option("--steps", steps, "of the pile, 1/60 s each, or of the cloth, 1/240 s each")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  std::string out;
  app.add_option("--out", out,
                 "a folder for the frames as PLY files: of the pile, the cloth, or the first throw of each");
  CLI11_PARSE(app, argc, argv);
  try {
    if (plates > 0) {
      tamis::bullet::report_pile(plates, drop, steps, out);
    } else if (side > 0) {
      tamis::bullet::report_cloth(side, steps, out);
    } else {
      tamis::bullet::report("Spinning plates", tamis::bullet::spinning_plates(count), samples, out);
      tamis::bullet::report("Spinning rods", tamis::bullet::spinning_rods(count), samples, out);
    }
  } catch (const std::exception& refused) {  // such as a file that cannot be written
    fmt::print(stderr, "tamis-bullet: {}\n", refused.what());
    return 2;
  }
  return 0;
}
