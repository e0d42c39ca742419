#include "integrations/bullet/throws/report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <vector>

#include "integrations/bullet/throws/cloth.hpp"
#include "integrations/bullet/throws/frames.hpp"
#include "integrations/bullet/throws/independent.hpp"

namespace tamis::bullet {

void report_throws(std::string_view title, const Scene& scene, int samples, const std::string& out) {
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

void report_bodies(std::string_view title, std::span<const BodyScene> scenes, std::span<const Measure> measures,
                   int steps, const std::string& out) {
  fmt::print("{}, {} steps\n{:8}", title, steps, "");
  for (const Measure& measure : measures) fmt::print(" {:>16}", measure.title);
  fmt::print(" {:>13} {:>16} {:>10} {:>10}\n", "not proven", "questions a step", "ms a step", "slowest");
  for (const bool clamped : {false, true}) {
    std::vector<double> measured(measures.size());
    int touching = 0;
    double questions = 0, milliseconds = 0, slowest = 0;
    for (const BodyScene& scene : scenes) {
      const BodyRun run = run_bodies(scene, steps, clamped);
      constexpr std::size_t kWithoutFloor = 1;
      if (!out.empty() && &scene == &scenes.front())
        write_frames(out, clamped ? "clamped" : "bullet", run.bodies, run.places, kWithoutFloor);
      for (std::size_t i = 0; i < measures.size(); ++i) {
        const double value = measures[i].of(run);
        measured[i] = measures[i].is_largest ? std::max(measured[i], value) : measured[i] + value;
      }
      touching += touching_steps(run.bodies, run.places);
      questions += run.questions / static_cast<double>(scenes.size());
      milliseconds += run.milliseconds / static_cast<double>(scenes.size());
      slowest = std::max(slowest, run.slowest);
    }
    fmt::print("{:8}", clamped ? "clamped" : "Bullet");
    for (const double value : measured) fmt::print(" {:>16.4g}", value);
    fmt::print(" {:>13} {:>16.2f} {:>10.3f} {:>10.3f}\n", touching, questions, milliseconds, slowest);
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

}  // namespace tamis::bullet
