// tamis within: the pairs of features of one pose that are near each other.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <span>

#include "command/command_line/printable.hpp"
#include "command/output_file.hpp"
#include "command/report.hpp"
#include "command/verbs/pose_verb.hpp"
#include "files/output/near_csv.hpp"

namespace tamis::cli {
namespace {

class Within final : public PoseVerb {
 public:
  const char* name() const override { return "within"; }
  const char* summary() const override { return "All pairs of features of MESH within a distance of each other"; }
  const char* examples() const override {
    return "  tamis within cloth.ply --distance 1e-3\n"
           "  tamis within cloth.ply --distance 1e-3 --out near.csv --json";
  }
  void declare(OptionList& options) override {
    PoseVerb::declare(options);
    declare_output(options, out_, "write the pairs, as CSV");
    options.add_number("--distance", "D", distance_, kNotNegative, "in the unit of the mesh").required();
    detector_.declare_radius(options, "a distance then counts beyond the sum of both radii");
  }

  int run() override {
    require_output(out_, {path_}, json_, "csv");
    io::MeshFile file = read();
    const std::vector<Point> positions = file.positions;
    Detector detector = detector_for(io::mesh_of(std::move(file)));
    std::span<const NearPair> pairs;
    const Timing timing =
        ask_repeatedly(detector, repeat_, [&] { pairs = detector.pairs_within(positions, distance_); });
    if (!out_.empty()) io::write_near_csv(out_, pairs);
    const auto touches = [](const NearPair& pair) { return pair.distance == 0; };
    if (std::ranges::any_of(pairs, touches)) note_coincident(detector.mesh(), positions);
    report(pairs, detector, timing);
    return kSuccess;
  }

 private:
  void report(std::span<const NearPair> pairs, const Detector& detector, const Timing& timing) const {
    std::size_t counts[kPairKinds] = {};
    for (const NearPair& pair : pairs) ++counts[static_cast<std::size_t>(pair.kind)];
    const auto& [vf, ee, ve, vv] = counts;
    const auto nearest = std::min_element(pairs.begin(), pairs.end(),
                                          [](const NearPair& a, const NearPair& b) { return a.distance < b.distance; });
    if (json_) {
      Json json{{"distance", distance_},
                {"within", {{"vf", vf}, {"ee", ee}, {"ve", ve}, {"vv", vv}}},
                {"smallest_distance", pairs.empty() ? Json() : Json(nearest->distance)}};
      add_costs(json, detector, timing);
      return print_json(json);
    }
    print_asked(detector);
    fmt::print("within {:<9.4g}{} vertex-face, {} edge-edge, {} vertex-edge, {} vertex-vertex\n", distance_,
               grouped(vf), grouped(ee), grouped(ve), grouped(vv));
    if (!pairs.empty()) fmt::print("smallest        {}\n", nearest->distance);
    if (!out_.empty()) fmt::print("written to      {}\n", printable(out_.string()));
    print_costs(detector.statistics(), timing, repeat_);
  }

  std::filesystem::path out_;
  double distance_ = 0;
};

}  // namespace

std::unique_ptr<Verb> make_within() { return std::make_unique<Within>(); }

}  // namespace tamis::cli
