// tamis intersections: does a mesh pass through itself?
#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "cli/pose_verb.hpp"
#include "cli/printable.hpp"
#include "cli/report.hpp"
#include "io/near_csv.hpp"

namespace tamis::cli {
namespace {

class IntersectionsVerb final : public PoseVerb {
 public:
  const char* name() const override { return "intersections"; }
  const char* summary() const override {
    return "Edges of MESH that pass through its triangles. Exit code 0: none, 1: some, 2: error";
  }
  const char* examples() const override {
    return "  tamis intersections cloth.ply && echo fit to start from\n"
           "  tamis intersections cloth.ply --out intersections.csv --json";
  }

  int run() override {
    io::MeshFile file = read();
    const std::vector<Point> positions = file.positions;
    Detector detector = detector_for(io::mesh_of(std::move(file)));
    const std::vector<Intersection>* found = nullptr;
    const Timing timing = ask_repeatedly(detector, repeat_, [&] { found = &detector.intersections(positions); });
    if (!out_.empty()) io::write_intersections_csv(out_, *found);
    report(*found, detector, timing);
    return found->empty() ? kSuccess : kNo;
  }

 private:
  const char* what() const override { return "write the intersections, as CSV: e0,e1,f0,f1,f2"; }

  void report(const std::vector<Intersection>& found, const Detector& detector, const Timing& timing) const {
    if (json_) {
      Json json{{"intersections", found.size()}};
      add_costs(json, detector, timing);
      return print_json(json);
    }
    print_mesh(detector.mesh());
    if (found.empty()) {
      fmt::print("intersections   none: no edge passes through a triangle or touches one, proven\n");
    } else {
      const auto& [edge, face, s_lower, s_upper, u, v] = found.front();
      fmt::print("intersections   {}\n", grouped(found.size()));
      fmt::print("first           edge {} {} and face {} {} {}, at {:.6g} of the edge\n", edge[0], edge[1], face[0],
                 face[1], face[2], s_upper);
    }
    if (!out_.empty()) fmt::print("written to      {}\n", printable(out_));
    print_costs(detector, timing, repeat_, "edge-face");
  }
};

}  // namespace

std::unique_ptr<Verb> make_intersections() { return std::make_unique<IntersectionsVerb>(); }

}  // namespace tamis::cli
