#include "command/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>

#include "files/system.hpp"

namespace tamis::cli {

std::string grouped(std::uint64_t number) {
  const std::string digits = std::to_string(number);
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) text += ',';
    text += digits[i];
  }
  return text;
}

std::string counted(std::uint64_t number, std::string_view noun, std::string_view nouns) {
  if (number == 1) return fmt::format("1 {}", noun);
  return nouns.empty() ? fmt::format("{} {}s", grouped(number), noun) : fmt::format("{} {}", grouped(number), nouns);
}

std::string of_loose_points(std::uint64_t ve, std::uint64_t vv) {
  return ve + vv > 0 ? fmt::format(", {} vertex-edge, {} vertex-vertex", grouped(ve), grouped(vv)) : "";
}

std::string no_later(double time) {
  constexpr double kLastDecimal = 1e-10;
  const std::string nearest = fmt::format("{:.10f}", time);
  return std::stod(nearest) <= time ? nearest : fmt::format("{:.10f}", std::max(time - kLastDecimal, 0.0));
}

std::string readable(double seconds) {
  if (seconds >= 1) return fmt::format("{:.2f} s", seconds);
  if (seconds >= 1e-3) return fmt::format("{:.1f} ms", seconds * 1e3);
  return fmt::format("{:.1f} us", seconds * 1e6);
}

void print_mesh(const Mesh& mesh) {
  fmt::print("mesh            {}, {}, {}\n",
             counted(static_cast<std::uint64_t>(mesh.vertex_count()), "vertex", "vertices"),
             counted(mesh.faces().size(), "triangle"), counted(mesh.edges().size(), "edge"));
}

void print_asked(const Detector& detector) {
  print_mesh(detector.mesh());
  if (const Index rings = detector.options().filter.rings; rings > 1)
    fmt::print("skipped         pairs fewer than {} edges apart along the mesh: nothing is proven about them\n", rings);
}

namespace {

void print_stages(const Statistics& statistics, std::string_view only_kind) {
  if (statistics.stages.empty()) return;
  std::size_t width = 15;
  bool has_loose_points = false;
  for (const StageCount& s : statistics.stages) {
    width = std::max(width, s.name.size());
    has_loose_points |= s.ve + s.vv > 0;
  }
  const auto print_row = [&](std::string_view name, const std::array<std::string, 4>& of_kind) {
    fmt::print("{:<{}}", name, width);
    for (std::size_t kind = 0; kind < (!only_kind.empty() ? 1 : has_loose_points ? 4 : 2); ++kind)
      fmt::print(" {:>15}", of_kind[kind]);
    fmt::print("\n");
  };
  fmt::print("\n");
  print_row("pairs entering",
            {only_kind.empty() ? "vertex-face" : std::string(only_kind), "edge-edge", "vertex-edge", "vertex-vertex"});
  for (const StageCount& s : statistics.stages)
    print_row(s.name, {grouped(s.vf), grouped(s.ee), grouped(s.ve), grouped(s.vv)});
}

void print_seconds(const char* name, const Seconds& s) {
  fmt::print("{:<15} {}, of this bounds {}, build {}, traverse {}, filter {}, solve {}\n", name, readable(s.total),
             readable(s.bounds), readable(s.build), readable(s.traverse), readable(s.filter), readable(s.solve));
}

}  // namespace

void print_costs(const Statistics& statistics, const Timing& timing, int repeat, std::string_view only_kind) {
  print_stages(statistics, only_kind);
  fmt::print("\n");
  print_seconds(repeat > 1 ? "first run" : "time", timing.cold);
  if (repeat > 1) print_seconds("later runs", timing.warm);
  constexpr double kMegabyte = 1e6;
  fmt::print("with            {} {}, {}, peak memory {:.0f} MB\n", statistics.threads,
             statistics.threads == 1 ? "thread" : "threads", name_of(statistics.isa),
             static_cast<double>(system::peak_memory_bytes()) / kMegabyte);
}

}  // namespace tamis::cli
