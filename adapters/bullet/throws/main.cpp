// How many throws each way of simulating lets through, whether that is proven, and what a step costs.
#include <fmt/core.h>

#include <CLI/CLI.hpp>

#include "adapters/bullet/throws/independent.hpp"
#include "adapters/bullet/throws/scenes.hpp"

namespace tamis::bullet {
namespace {

void report(std::string_view title, const Scene& scene, int samples) {
  fmt::print("{}: {} throws\n{:28} {:>9} {:>13} {:>16} {:>10}\n", title, scene.trials.size(), "", "through",
             "not proven", "sampled crossing", "ms a step");
  for (const Method method :
       {Method::hull, Method::hull_ccd, Method::mesh, Method::clamped_hull, Method::clamped_mesh}) {
    int through = 0, touching = 0, crossing = 0, steps = 0;
    double milliseconds = 0;
    for (const Trial& trial : scene.trials) {
      const Flight flight = trial.arena->fly(method, trial.thrown);
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

}  // namespace
}  // namespace tamis::bullet

int main(int argc, char** argv) {
  CLI::App app("Throws bodies at meshes in Bullet, as it is and clamped; counts those that pass through");
  int count = 40, samples = 16;
  app.add_option("--throws", count, "of each kind")->check(CLI::Range(1, 100000))->capture_default_str();
  app.add_option("--samples", samples, "times in each step at which crossings are looked for")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  tamis::bullet::report("Spinning plates", tamis::bullet::spinning_plates(count), samples);
  tamis::bullet::report("Spinning rods", tamis::bullet::spinning_rods(count), samples);
  return 0;
}
