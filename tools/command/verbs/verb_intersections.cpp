// tamis intersections: does a mesh pass through itself?
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>
#include <span>

#include "command/collapse_check.hpp"
#include "command/command_line/printable.hpp"
#include "command/look_output.hpp"
#include "command/report.hpp"
#include "command/verbs/pose_verb.hpp"

namespace tamis::cli {
namespace {

constexpr std::uint64_t kMostListed = 1'000'000'000'000;

/// With the point along the edge where they first meet, and its weights on the face.
Json json_of(const Intersection& i) {
  return {{"edge", i.edge}, {"face", i.face}, {"s_lower", i.s_lower}, {"s_upper", i.s_upper}, {"u", i.u}, {"v", i.v}};
}

class IntersectionsVerb final : public PoseVerb {
 public:
  const char* name() const override { return "intersections"; }
  const char* summary() const override {
    return "Edges of MESH that pass through its triangles. Exit code 0: none, 1: some, 2: error";
  }
  const char* examples() const override {
    return "  tamis intersections cloth.ply && echo fit to start from\n"
           "  tamis intersections cloth.ply --out intersections.csv --json\n"
           "  tamis intersections cloth.ply --out where.html";
  }
  void declare(OptionList& options) override {
    PoseVerb::declare(options);
    output_.declare(options);
    options.add_number("--limit", "N", limit_, NumberRange<std::uint64_t>{0, kMostListed},
                       "list no more than N intersections in JSON; all are counted; default 100000");
  }

  int run() override {
    output_.require({path_}, 0, json_);
    io::MeshFile file = read();
    const std::vector<Point> positions = file.positions;
    Mesh mesh = io::mesh_of(std::move(file));
    CollapseCheck collapse(mesh);
    collapse.look(path_.string(), positions);
    std::optional<Mesh> asked = collapse.passes() ? std::move(mesh) : collapse.rest();
    if (!asked) return collapse.refuse(json_);
    Detector detector = detector_for(std::move(*asked));
    std::span<const Intersection> found;
    const Timing timing = ask_repeatedly(detector, repeat_, [&] { found = detector.intersections(positions); });
    output_.write(recording_of(detector, path_, positions, found));
    if (!found.empty() && collapse.passes()) note_coincident(detector.mesh(), positions);
    report(found, collapse, detector, timing);
    return found.empty() && collapse.passes() ? kSuccess : kNo;
  }

 private:
  void report(std::span<const Intersection> found, const CollapseCheck& collapse, const Detector& detector,
              const Timing& timing) const {
    if (json_) {
      Json json{{"intersections", found.size()}, {"pairs", Json::array()}};
      const std::size_t listed = std::min<std::size_t>(found.size(), limit_);
      for (std::size_t i = 0; i < listed; ++i) json["pairs"].push_back(json_of(found[i]));
      json["pairs_left_out"] = found.size() - listed;
      if (!collapse.passes()) collapse.add_to(json);
      add_costs(json, detector, timing);
      return print_json(json);
    }
    print_asked(detector);
    if (!collapse.passes()) collapse.print();
    if (found.empty() && !collapse.passes())
      fmt::print("intersections   none among the other objects\n");
    else if (found.empty())
      fmt::print(
          "intersections   none: no edge passes through a triangle that shares no vertex with it, or touches one, "
          "proven\n");
    else
      print_table(found);
    if (!output_.path().empty()) fmt::print("\nwritten to      {}\n", printable(output_.path().string()));
    print_costs(detector.statistics(), timing, repeat_, "edge-face");
  }

  static void print_table(std::span<const Intersection> found) {
    constexpr std::size_t kPrinted = 20;
    fmt::print("intersections   {}\n\n{:<23} {:<31} {:>15}\n", grouped(found.size()), "edge", "face",
               "at, of the edge");
    for (std::size_t i = 0; i < std::min(found.size(), kPrinted); ++i) {
      const auto& [edge, face, s_lower, s_upper, u, v] = found[i];
      fmt::print("{:<23} {:<31} {:>15.6g}\n", fmt::format("{} {}", edge[0], edge[1]),
                 fmt::format("{} {} {}", face[0], face[1], face[2]), s_upper);
    }
    if (found.size() > kPrinted)
      fmt::print("and {} more: --json or --out FILE.csv lists all, --out FILE.html shows them\n",
                 grouped(found.size() - kPrinted));
  }

  std::uint64_t limit_ = 100'000;
  LookOutput output_{"", io::NoExtension::is_first_format, Shown::pose};
};

}  // namespace

std::unique_ptr<Verb> make_intersections() { return std::make_unique<IntersectionsVerb>(); }

}  // namespace tamis::cli
