#include "cli/arguments.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/components.hpp"
#include "tamis/error.hpp"

namespace tamis::cli {
namespace {

void require_one_each(std::size_t radii, Index objects) {
  if (radii == static_cast<std::size_t>(objects)) return;
  throw InvalidOptions(fmt::format(
      "--thickness: {} radii for {} object{} (what vertices connect; 'tamis info' counts them): give one radius for "
      "all, or one for each, in the order of their first vertices",
      radii, objects, objects == 1 ? "" : "s"));
}

}  // namespace

void DetectorArguments::declare(CLI::App& app) {
  app.add_option("--method", method_,
                 "tamis (default), paper (the published pipeline), brute (every pair; slow), or a competitor of the "
                 "paper: paper-sat, paper-pfs, ...")
      ->type_name("NAME");
  declare_bounding_volume(app, bounding_volume_);
  declare_guarantee(app, guarantee_);
  declare_min_separation(app, min_separation_);
  add_numbers(app, "--thickness", "R", thickness_, kNotNegative,
              "a radius for all objects, or one for each; contact then means a distance <= the sum of both radii and "
              "the minimum separation. An object is what vertices connect ('tamis info' counts them, as components), "
              "in the order of their first vertices");
  add_number(app, "--threads", "N", threads_, kThreadCounts, "threads to use; 0, the default: all");
  app.add_option("--isa", isa_, "instruction set of the hot loops: best (default), baseline, avx2 or avx512")
      ->type_name("NAME");
}

Options DetectorArguments::options() const {
  Options options;
  choose_method(options, method_);
  options.paper.bounding_volume = bounding_volume_from_name(bounding_volume_);
  options.guarantee = guarantee_from_name(guarantee_);
  options.isa = isa_from_name(isa_);
  options.threads = threads_;
  options.min_separation = min_separation_;
  return options;
}

Detector DetectorArguments::detector(Mesh mesh) const {
  Options chosen = options();
  chosen.thickness = thickness_;
  if (thickness_.size() > 1) {
    Components objects = components_of(mesh);
    require_one_each(thickness_.size(), objects.count);
    for (Index& object : objects.of_vertex) object = std::max(object, Index{0});  // of no use, but in some group
    chosen.filter.group_of_vertex = std::move(objects.of_vertex);
    chosen.filter.group_count = objects.count;
  }
  return Detector(std::move(mesh), std::move(chosen));
}

void ScaleArgument::declare(CLI::App& app) {
  add_number(app, "--scale", "S", scale_, kNotNegative, "take END = START + S (END - START); default 1");
}

void declare_json(CLI::App& app, bool& json) {
  app.add_flag("--json", json, "print one JSON object and nothing else on the standard output");
}

void declare_repeat(CLI::App& app, int& repeat, const std::string& help) {
  add_number(app, "--repeat", "N", repeat, kRunCounts, help);
}

void declare_seed(CLI::App& app, std::uint64_t& seed, const std::string& of) {
  add_number(app, "--seed", "S", seed, {}, "of " + of + "; default 1");
}

void declare_guarantee(CLI::App& app, std::string& guarantee) {
  app.add_option(
         "--guarantee", guarantee,
         "what floating point cannot decide: exact (default) decides it by exact algebra, conservative reports it "
         "as an unresolved contact")
      ->type_name("NAME");
}

void declare_bounding_volume(CLI::App& app, std::string& volume) {
  app.add_option("--bounding-volume", volume,
                 "of the paper's hierarchy and its competitors': sphere, aabb, obb, 16-dop (default), 18-dop or "
                 "26-dop; other methods have their own")
      ->type_name("NAME");
}

void declare_min_separation(CLI::App& app, double& distance) {
  add_number(app, "--min-separation", "D", distance, kNotNegative,
             "contact means a distance <= D, in the unit of the mesh; default 0");
}

}  // namespace tamis::cli
