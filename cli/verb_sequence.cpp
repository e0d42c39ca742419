// tamis sequence: the contacts of each pair of consecutive frames, with one detector.
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "cli/arguments.hpp"
#include "cli/moving_frames.hpp"
#include "cli/printable.hpp"
#include "cli/progress.hpp"
#include "cli/report.hpp"
#include "cli/step_files.hpp"
#include "cli/verb.hpp"

namespace tamis::cli {
namespace {

class Sequence final : public Verb {
 public:
  const char* name() const override { return "sequence"; }
  const char* summary() const override { return "Contacts of each consecutive pair of frames"; }
  const char* examples() const override {
    return "  tamis sequence frames/\n"
           "  tamis sequence 'frames/cloth*.ply' --threads 1\n"
           "  tamis sequence a1.ply a2.ply a10.ply --json\n"
           "  tamis sequence frames/ --substeps 20";
  }
  void declare(CLI::App& app) override {
    app.add_option("FRAMES", names_, "files, folders or patterns of PLY or OBJ; taken in natural order (2 before 10)")
        ->required();
    detector_.declare(app);
    scale_.declare(app);
    add_number(app, "--substeps", "N", substeps_, kRunCounts,
               "cut each step into N equal ones, asked one after the other; default 1");
    declare_json(app, json_);
  }

  int run() override {
    detector_.check();
    const double scale = scale_.value();
    const MovingFrames frames(names_);
    frames_ = frames.paths();
    for (const auto& frame : frames_)
      width_ =
          std::max(width_, static_cast<int>(printable(frame.filename().string()).size() + part_of(substeps_).size()));
    std::vector<Point> start = frames.first().positions;
    Detector detector = detector_.detector(io::mesh_of(frames.first()));
    if (!json_) print_head(detector);
    Progress progress(frames_.size() - 1, "steps");
    for (std::size_t i = 1; i < frames_.size(); ++i) {
      std::vector<Point> end = frames.read(i);
      std::vector<Point> scaled = end;
      scale_step(start, scaled, scale);
      for (int part = 1; part <= substeps_; ++part) {
        const auto at = [&](int n) {
          return n == 0 ? start : n == substeps_ ? scaled : between(start, scaled, static_cast<double>(n) / substeps_);
        };
        const std::vector<Point> from = at(part - 1), to = at(part);
        const Tally tally = tally_of(detector.contacts({from, to}));
        progress.clear();
        add_step(i, part, tally, detector.statistics());
      }
      progress.show(i);
      start = std::move(end);
    }
    progress.clear();
    report_totals(detector);
    return kSuccess;
  }

 private:
  /// " 3/20", or nothing if steps are whole.
  std::string part_of(int part) const { return substeps_ == 1 ? "" : fmt::format(" {}/{}", part, substeps_); }

  void print_head(const Detector& detector) const {
    print_mesh(detector.mesh());
    fmt::print("\n{:>5} {:<{}} {:>11} {:>11} {:>10} {:>14} {:>10}  {}\n", "step", "end", width_, "vertex-face",
               "edge-edge", "unresolved", "free until", "time", "tree");
  }

  void add_step(std::size_t i, int part, const Tally& tally, const Statistics& statistics) {
    total_.add_counts(tally);
    seconds_ += statistics.seconds.total;
    free_steps_ += tally.is_free() ? 1 : 0;
    ++steps_asked_;
    if (!json_) return print_row(i, part, tally, statistics);
    Json step{{"start", frames_[i - 1].string()}, {"end", frames_[i].string()}, {"contacts", json_of(tally)}};
    if (substeps_ > 1) step["substep"] = part;
    add_bracket(step, tally.is_free(), tally.toi_lower, tally.toi_upper);
    step["seconds"] = json_of(statistics.seconds);
    step["rebuilt"] = statistics.rebuilt;
    steps_.push_back(std::move(step));
  }

  void print_row(std::size_t i, int part, const Tally& tally, const Statistics& statistics) const {
    fmt::print("{:>5} {:<{}} {:>11} {:>11} {:>10} {:>14} {:>10}  {}\n", i,
               printable(frames_[i].filename().string()) + part_of(part), width_, grouped(tally.vf), grouped(tally.ee),
               grouped(tally.unresolved),
               tally.is_free() ? std::string("end") : fmt::format("{:.10f}", tally.toi_lower),
               readable(statistics.seconds.total), statistics.rebuilt ? "built" : "refitted");
    std::fflush(stdout);
  }

  void report_totals(const Detector& detector) {
    if (!json_) {
      fmt::print("{:>5} {:<{}} {:>11} {:>11} {:>10} {:>14} {:>10}\n", "total", "", width_, grouped(total_.vf),
                 grouped(total_.ee), grouped(total_.unresolved), fmt::format("{}/{} free", free_steps_, steps_asked_),
                 readable(seconds_));
      return;
    }
    const Statistics& statistics = detector.statistics();
    print_json({{"steps", std::move(steps_)},
                {"contacts", json_of(total_)},
                {"free_steps", free_steps_},
                {"seconds", {{"total", seconds_}}},
                {"peak_memory_bytes", peak_memory_bytes()},
                {"threads", statistics.threads},
                {"method", name_of(statistics.method)},
                {"guarantee", name_of(detector.options().guarantee)},
                {"min_separation", detector.options().min_separation},
                {"thickness", detector.options().thickness},
                {"isa", name_of(statistics.isa)}});
  }

  std::vector<std::string> names_;
  DetectorArguments detector_;
  ScaleArgument scale_;
  bool json_ = false;
  std::vector<std::filesystem::path> frames_;
  int width_ = 5;
  Tally total_;
  int substeps_ = 1;
  std::size_t steps_asked_ = 0, free_steps_ = 0;
  double seconds_ = 0;
  Json steps_ = Json::array();
};

}  // namespace

std::unique_ptr<Verb> make_sequence() { return std::make_unique<Sequence>(); }

}  // namespace tamis::cli
