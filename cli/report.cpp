#include "cli/report.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cstdio>

namespace tamis::cli {

std::uint64_t peak_memory_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  constexpr std::uint64_t kKibibyte = 1024;
  return static_cast<std::uint64_t>(usage.ru_maxrss) * kKibibyte;
}

std::string grouped(std::uint64_t number) {
  const std::string digits = std::to_string(number);
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) text += ',';
    text += digits[i];
  }
  return text;
}

std::string readable(double seconds) {
  if (seconds >= 1) return fmt::format("{:.2f} s", seconds);
  if (seconds >= 1e-3) return fmt::format("{:.1f} ms", seconds * 1e3);
  return fmt::format("{:.1f} us", seconds * 1e6);
}

void print_bracket(double toi_lower, double toi_upper, bool is_certified) {
  if (!is_certified) {
    fmt::print(
        "first contact   free before {}, proven; then a pair that doubles cannot decide (--guarantee exact can)\n",
        toi_lower);
    return;
  }
  fmt::print("first contact   at {:.12g} of the step; free before {}, proven; bracket {:.1e} wide\n", toi_upper,
             toi_lower, toi_upper - toi_lower);
}

namespace {

void print_between(PairKind kind, const std::array<Index, 4>& v) {
  switch (kind) {
    case PairKind::vertex_face:
      return fmt::print("between         vertex {} and face {} {} {}", v[0], v[1], v[2], v[3]);
    case PairKind::edge_edge:
      return fmt::print("between         edge {} {} and edge {} {}", v[0], v[1], v[2], v[3]);
    case PairKind::vertex_edge:
      return fmt::print("between         vertex {} and edge {} {}", v[0], v[1], v[2]);
    case PairKind::vertex_vertex:
      return fmt::print("between         vertex {} and vertex {}", v[0], v[1]);
  }
}

void print_limit(const SafeStep& safe, double fraction, const std::string& distance) {
  if (safe.lower == 0)
    fmt::print("step            0: a pair touches at the start\n");
  else if (fraction == 0)
    fmt::print("step            {}; no pair touches before it, proven\n", safe.lower);
  else
    fmt::print("step            {}; on it every pair keeps {} of its {}, proven\n", safe.lower, fraction, distance);
  if (safe.lower > 0 && safe.upper < 1)
    fmt::print("largest         not above {}, proven: {:.1e} more\n", safe.upper, safe.upper - safe.lower);
}

}  // namespace

void print_safe_step(const SafeStep& safe, double fraction, double min_separation) {
  const std::string distance =
      min_separation > 0 ? fmt::format("distance beyond {}", min_separation) : std::string("distance");
  if (!safe.pair) {
    fmt::print("step            1: the whole step may go, proven\n");
    return;
  }
  print_limit(safe, fraction, distance);
  print_between(safe.pair->kind, safe.pair->vertices);
  fmt::print(", {:.6g} apart at the start\n", safe.pair->distance);
}

void print_contact(const Contact& c) {
  print_between(c.kind, c.vertices);
  fmt::print(", u = {:.6g}, v = {:.6g}, normal ({:.6g}, {:.6g}, {:.6g}), {}\n", c.u, c.v, c.normal[0], c.normal[1],
             c.normal[2], c.certainty == Certainty::certified ? "certified" : "unresolved");
}

void print_mesh(const Mesh& mesh) {
  fmt::print("mesh            {} vertices, {} triangles, {} edges\n",
             grouped(static_cast<std::uint64_t>(mesh.vertex_count())), grouped(mesh.faces().size()),
             grouped(mesh.edges().size()));
}

namespace {

void print_stages(const Statistics& statistics) {
  if (statistics.stages.empty()) return;
  std::size_t width = 15;
  for (const StageCount& s : statistics.stages) width = std::max(width, s.name.size());
  fmt::print("\n{:<{}} {:>15} {:>15}\n", "pairs entering", width, "vertex-face", "edge-edge");
  for (const StageCount& s : statistics.stages)
    fmt::print("{:<{}} {:>15} {:>15}\n", s.name, width, grouped(s.vf), grouped(s.ee));
}

void print_seconds(const char* name, const Seconds& s) {
  fmt::print("{:<15} {} = bounds {} + build {} + traverse {} + filter {} + solve {}\n", name, readable(s.total),
             readable(s.bounds), readable(s.build), readable(s.traverse), readable(s.filter), readable(s.solve));
}

}  // namespace

void print_costs(const Detector& detector, const Timing& timing, int repeat) {
  const Statistics& statistics = detector.statistics();
  print_stages(statistics);
  fmt::print("\n");
  print_seconds(repeat > 1 ? "first run" : "time", timing.cold);
  if (repeat > 1) print_seconds("later runs", timing.warm);
  constexpr double kMegabyte = 1e6;
  fmt::print("with            method {}, {}, {} {}, {}, peak memory {:.0f} MB\n", name_of(statistics.method),
             name_of(detector.options().guarantee), statistics.threads, statistics.threads == 1 ? "thread" : "threads",
             name_of(statistics.isa), static_cast<double>(peak_memory_bytes()) / kMegabyte);
}

}  // namespace tamis::cli
