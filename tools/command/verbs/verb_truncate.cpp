// tamis truncate: where a step may end if each vertex goes its own part of its way.
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <memory>

#include "command/collapse_check.hpp"
#include "command/command_line/printable.hpp"
#include "command/output_file.hpp"
#include "command/report.hpp"
#include "command/start_check.hpp"
#include "command/verbs/step_verb.hpp"
#include "files/mesh/ply.hpp"

namespace tamis::cli {
namespace {

/// Another frame of the mesh that was read.
io::MeshFile frame_of(const Mesh& mesh, const StepFiles& files, const std::vector<Point>& positions) {
  return {positions, {mesh.faces().begin(), mesh.faces().end()}, files.loose_edges, files.loose_points, {}};
}

/// The sum of the ways of all vertices in use to `to`, as a part of the sum of their ways to the end.
double part_of_way(const Mesh& mesh, const Step& step, const std::vector<Point>& to) {
  double gone = 0, all = 0;
  for (const Index v : mesh.points()) {
    const double *a = step.start[v], *b = step.end[v], *c = to[static_cast<std::size_t>(v)].data();
    gone += std::hypot(c[0] - a[0], c[1] - a[1], c[2] - a[2]);
    all += std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
  }
  return all > 0 ? gone / all : 1;
}

class Truncate final : public StepVerb {
 public:
  const char* name() const override { return "truncate"; }
  const char* summary() const override { return "Positions to go to: the way there is proven free"; }
  const char* examples() const override {
    return "  tamis truncate cloth1.ply cloth2.ply --out next.ply\n"
           "  tamis truncate cloth1.ply cloth2.ply --out next.ply --keep 0.5 --json\n"
           "  tamis truncate cloth1.ply cloth2.ply --out next.ply --check-start\n\n"
           "Exit code 1: something touches at the start. It comes no nearer, but no way from there is free.";
  }

  void declare(OptionList& options) override {
    StepVerb::declare(options);
    declare_output(options, out_, "write the positions, as PLY");
    options.add_number(
        "--keep", "F", keep_, {.least = 1e-6, .most = 1, .takes_most = false},
        "every pair keeps at least F of its distance at START, beyond the minimum separation if there is one; "
        "default 0.1");
    start_check_.declare(options);
  }

  int run() override {
    require_output(out_, {start_, end_}, json_, "ply");
    StepFiles files = read();
    Detector detector = detector_for(std::move(files.mesh));
    const Step step = files.step();
    if (!start_check_.passes(detector, step.start)) return start_check_.refuse(detector, json_, {{"free", false}});
    TruncatedStep to;
    const Timing timing = ask_repeatedly(detector, repeat_, [&] { to = detector.truncate(step, keep_, own()); });
    if (!out_.empty()) io::write_ply(out_, frame_of(detector.mesh(), files, to.positions));
    const double part = part_of_way(detector.mesh(), step, to.positions);
    if (!to.is_free || part < 1) note_causes(detector.mesh(), start_.string(), step.start, end_.string(), step.end);
    report(to, part, detector, timing);
    return to.is_free ? kSuccess : kNo;
  }

 private:
  void report(const TruncatedStep& to, double part, const Detector& detector, const Timing& timing) const {
    if (json_) {
      Json json{{"free", to.is_free}, {"part_of_way", part}};
      start_check_.add_to(json);
      add_costs(json, detector, timing);
      return print_json(json);
    }
    print_asked(detector);
    fmt::print(
        "truncated       to {:.6g} of the summed way of all vertices; {}\n", part,
        to.is_free ? "the straight way there is free, proven" : "something touches at the start, and comes no nearer");
    if (to.is_free) start_check_.print();
    if (!out_.empty()) fmt::print("written to      {}\n", printable(out_.string()));
    print_costs(detector.statistics(), timing, repeat_);
  }

  StartCheck start_check_;
  std::filesystem::path out_;
  double keep_ = 0.1;
};

}  // namespace

std::unique_ptr<Verb> make_truncate() { return std::make_unique<Truncate>(); }

}  // namespace tamis::cli
