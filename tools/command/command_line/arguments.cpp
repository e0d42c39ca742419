#include "command/command_line/arguments.hpp"

#include <fmt/format.h>

#include "tamis/components.hpp"
#include "tamis/error.hpp"

namespace tamis::cli {
namespace {

void require_one_each(std::size_t radii, Index objects) {
  if (radii == static_cast<std::size_t>(objects)) return;
  throw InvalidOptions(fmt::format(
      "--radius: {} radii for {} object{} (what vertices connect; 'tamis info' counts them): give one radius for "
      "all, or one for each, in the order of their first vertices",
      radii, objects, objects == 1 ? "" : "s"));
}

}  // namespace

void DetectorArguments::declare(OptionList& options) {
  declare_for_bodies(options);
  declare_radius(options, "contact then means a distance <= the sum of both radii and the minimum separation");
}

void DetectorArguments::declare_for_bodies(OptionList& options) {
  declare_means(options);
  declare_min_separation(options, min_separation_);
}

void DetectorArguments::declare_means(OptionList& options) {
  options.add_number("--threads", "N", threads_, kThreadCounts, "threads to use; 0, the default: all");
  options.add_number("--rings", "K", rings_, kRings,
                     "skip pairs whose features are fewer than K edges apart along the mesh; 1, the default: pairs "
                     "with a common vertex");
  options.add_text("--isa", isa_, "instruction set of the hot loops: best (default), baseline, avx2 or avx512")
      .shown_as("NAME");
}

void DetectorArguments::declare_radius(OptionList& options, const std::string& meaning) {
  options.add_numbers("--radius", "R", radii_, kNotNegative,
                      "a radius for all objects, or one for each; " + meaning +
                          ". An object is what vertices connect ('tamis info' counts them, as components), in the "
                          "order of their first vertices");
}

Options DetectorArguments::chosen() const {
  Options options;
  options.isa = isa_from_name(isa_);
  options.threads = threads_;
  options.min_separation = min_separation_;
  options.filter.rings = rings_;
  return options;
}

Options DetectorArguments::options() const {
  if (radii_.size() > 1)
    throw InvalidOptions(fmt::format(
        "--radius: {} radii: only the whole mesh tells which vertices make an object; give one radius for all",
        radii_.size()));
  Options options = chosen();
  options.radii = radii_;
  return options;
}

Options DetectorArguments::options_for(const Mesh& mesh) const {
  Options options = chosen();
  options.radii = radii_;
  if (radii_.size() > 1) {
    Components objects = components_of(mesh);
    require_one_each(radii_.size(), objects.count);
    options.filter.group_of_vertex = std::move(objects.of_vertex);
    options.filter.group_count = objects.count;
  }
  return options;
}

Detector DetectorArguments::detector(Mesh mesh) const {
  Options options = options_for(mesh);
  return Detector(std::move(mesh), std::move(options));
}

void AtStartArgument::declare(OptionList& options) {
  options
      .add_text("--at-start", name_,
                "pairs that touch at START: report (default), ignore until they have come apart, or fail (exit code 2, "
                "and the first of them)")
      .shown_as("WAY");
}

void ScaleArgument::declare(OptionList& options) {
  options.add_number("--scale", "S", scale_, kNotNegative, "take END = START + S (END - START); default 1");
}

void KeepArgument::declare(OptionList& options) {
  options.add_number(
      "--keep", "F", keep_, {.least = 0, .most = 1, .takes_most = false},
      "every pair keeps at least F times its distance at START, beyond the minimum separation if there is "
      "one; 0: only contacts count; default 0.1");
}

void WeldArgument::declare(OptionList& options) {
  option_ = options
                .add_number("--weld", "D", distance_, kNotNegative,
                            "join vertices that lie within D of each other in every frame; without a number, those at "
                            "exactly one place")
                .shown_as("[D >= 0]");
}

void declare_json(OptionList& options, bool& json) {
  options.add_flag("--json", json, "print one JSON object and nothing else on the standard output");
}

void declare_repeat(OptionList& options, int& repeat, const std::string& help) {
  options.add_number("--repeat", "N", repeat, kRunCounts, help);
}

Option declare_seed(OptionList& options, std::uint64_t& seed, const std::string& of) {
  return options.add_number("--seed", "S", seed, {}, "of " + of + "; default 1");
}

void declare_min_separation(OptionList& options, double& distance) {
  options.add_number("--min-separation", "D", distance, kNotNegative,
                     "contact means a distance <= D, in the unit of the mesh; default 0");
}

}  // namespace tamis::cli
