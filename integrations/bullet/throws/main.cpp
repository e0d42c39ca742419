// For each way of simulating a scene: what passes through what, what hangs, and the cost of a step.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <exception>
#include <initializer_list>
#include <string>
#include <vector>

#include "integrations/bullet/throws/body_scenes.hpp"
#include "integrations/bullet/throws/fine_scenes.hpp"
#include "integrations/bullet/throws/report.hpp"

namespace tamis::bullet {
namespace {

constexpr Measure kHang{"hang", [](const BodyRun& run) { return static_cast<double>(hanging(run).size()); }};
constexpr Measure kHangingSpeed{"wanting m/s", hanging_speed, true};
constexpr Measure kOverlap{"overlap at end", [](const BodyRun& run) { return static_cast<double>(overlapping(run)); }};
constexpr Measure kInside{"inside", [](const BodyRun& run) { return static_cast<double>(plates_inside(run)); }};
constexpr Measure kBefore{"momentum before", [](const BodyRun& run) { return momentum(run)[0]; }};
constexpr Measure kAfter{"and after", [](const BodyRun& run) { return momentum(run)[1]; }};
constexpr Measure kAboveFloor{"ends above, mm", [](const BodyRun& run) { return 1e3 * peg_above_floor(run); }};

/// Where the numbers of the command line go.
struct Asked {
  int throws = 40, samples = 16, steps = 60;
  int pile = 0, drops = 0, mixed = 0, blocks = 0, stacks = 0, row = 0, rough = 0, cloth = 0;
  bool gears = false;
  double drop = 0.0015, peg = 0;
  std::string out;
};

std::vector<BodyScene> one_a_seed(int count, BodyScene (*scene)(unsigned seed)) {
  std::vector<BodyScene> scenes;
  for (int seed = 0; seed < count; ++seed) scenes.push_back(scene(static_cast<unsigned>(seed)));
  return scenes;
}

void report(const Asked& asked) {
  const auto bodies = [&](const std::string& title, const std::vector<BodyScene>& scenes,
                          std::initializer_list<Measure> measures) {
    report_bodies(title, scenes, std::vector(measures), asked.steps, asked.out);
  };
  if (asked.pile > 0) {
    bodies(fmt::format("A pile of {} plates", asked.pile), {pile(asked.pile, asked.drop)}, {kInside});
  } else if (asked.drops > 0) {
    bodies(fmt::format("{} drops of a turned box", asked.drops), one_a_seed(asked.drops, drop_of_a_box),
           {kHang, kHangingSpeed});
  } else if (asked.mixed > 0) {
    bodies(fmt::format("30 mixed bodies, {} times", asked.mixed), one_a_seed(asked.mixed, mixed_bodies),
           {kHang, kHangingSpeed, kOverlap});
  } else if (asked.blocks > 0) {
    bodies(fmt::format("{0} x {0} x {0} boxes exactly on each other", asked.blocks), {blocks(asked.blocks)},
           {kHang, kHangingSpeed, kOverlap});
  } else if (asked.stacks > 0) {
    bodies(fmt::format("{} boxes in stacks of four, awake", asked.stacks), {stacks(asked.stacks, Sleep::never)},
           {kHang, kOverlap});
    bodies("The same, asleep", {stacks(asked.stacks, Sleep::from_the_start)}, {kHang, kOverlap});
  } else if (asked.row > 0) {
    bodies(fmt::format("A row of {} free cubes", asked.row), {row_of_cubes(asked.row)}, {kBefore, kAfter});
  } else if (asked.peg > 0) {
    bodies(fmt::format("A peg with {} mm on each side", asked.peg), {peg_in_tube(asked.peg / 1e3)}, {kAboveFloor});
  } else if (asked.rough > 0) {
    bodies(fmt::format("Four rough balls of {} triangles", asked.rough), {rough_balls(asked.rough)}, {kHang, kOverlap});
  } else if (asked.gears) {
    bodies("Two gears of 1,120 and 1,920 triangles", {gears()}, {kHang, kOverlap});
  } else if (asked.cloth > 0) {
    report_cloth(asked.cloth, asked.steps, asked.out);
  } else {
    report_throws("Spinning plates", spinning_plates(asked.throws), asked.samples, asked.out);
    report_throws("Spinning rods", spinning_rods(asked.throws), asked.samples, asked.out);
  }
}

void add_options(CLI::App& app, Asked& asked) {
  app.add_option("--throws", asked.throws, "of each kind, where no other scene is named")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  app.add_option("--samples", asked.samples, "times in each step of a throw at which crossings are looked for")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  auto* const scene = app.add_option_group("scenes", "other scenes than throws")->require_option(0, 1);
  auto* const pile =
      scene->add_option("--pile", asked.pile, "a pile of so many thin plates")->check(CLI::Range(1, 1000));
  scene->add_option("--drops", asked.drops, "so many turned boxes, each dropped on a floor")
      ->check(CLI::Range(1, 100000));
  scene->add_option("--mixed", asked.mixed, "30 mixed bodies thrown into a pit, so many times")
      ->check(CLI::Range(1, 1000));
  scene->add_option("--blocks", asked.blocks, "boxes exactly on each other, so many along each side of a cube")
      ->check(CLI::Range(1, 20));
  scene->add_option("--stacks", asked.stacks, "so many boxes in stacks of four, awake and asleep")
      ->check(CLI::Range(1, 10000));
  scene->add_option("--row", asked.row, "so many free cubes in a row, hit by the first")->check(CLI::Range(2, 1000));
  scene->add_option("--peg", asked.peg, "a peg in a tube, with so many millimetres on each side")
      ->check(CLI::Range(0.01, 100.0));
  scene->add_option("--rough", asked.rough, "four rough balls in a pit, of about so many triangles each")
      ->check(CLI::Range(48, 1000000));
  scene->add_flag("--gears", asked.gears, "a gear of 1,120 triangles that drives one of 1,920");
  scene->add_option("--cloth", asked.cloth, "a cloth of so many vertices a side")->check(CLI::Range(2, 1000));
  app.add_option("--drop", asked.drop, "how far each plate of the pile is above the next at first, in metres")
      ->check(CLI::Range(1e-4, 100.0))
      ->needs(pile)
      ->capture_default_str();
  app.add_option("--steps", asked.steps, "of a scene, 1/60 s each, or of the cloth, 1/240 s each")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  app.add_option("--out", asked.out,
                 "a folder for the frames as PLY files: of the scene, or of the first throw of each");
}

}  // namespace
}  // namespace tamis::bullet

int main(int argc, char** argv) {
  CLI::App app("Puts scenes into Bullet, as it is and with Tamis: what passes through, what hangs, what a step costs");
  tamis::bullet::Asked asked;
  tamis::bullet::add_options(app, asked);
  CLI11_PARSE(app, argc, argv);
  try {
    tamis::bullet::report(asked);
  } catch (const std::exception& refused) {  // such as a file that cannot be written
    fmt::print(stderr, "tamis-bullet: {}\n", refused.what());
    return 2;
  }
  return 0;
}
