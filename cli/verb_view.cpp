// tamis view: a step, or a sequence of them, in one HTML file.
#include <fmt/format.h>

#include <memory>

#include "cli/arguments.hpp"
#include "cli/moving_frames.hpp"
#include "cli/output_file.hpp"
#include "cli/printable.hpp"
#include "cli/progress.hpp"
#include "cli/report.hpp"
#include "cli/step_files.hpp"
#include "cli/verb.hpp"
#include "cli/view/outputs.hpp"

namespace tamis::cli {
namespace {

class View final : public Verb {
 public:
  const char* name() const override { return "view"; }
  const char* summary() const override { return "One HTML file that shows a step, or a sequence, with its contacts"; }
  const char* examples() const override {
    return "  tamis view cloth1.ply cloth2.ply --out step.html\n"
           "  tamis view 'frames/cloth*.ply' --out film.html\n"
           "  tamis view cloth1.ply cloth2.ply --scale 10 --out step.glb";
  }
  void declare(CLI::App& app) override {
    app.add_option("FRAMES", names_, "START END, or more: files, folders or patterns of PLY or OBJ, in natural order")
        ->required();
    declare_output(app, out_, fmt::format("the file to write: {}; default {}", output_extensions(), out_));
    detector_.declare(app);
    scale_.declare(app);
    declare_json(app, json_);
  }

  int run() override {
    detector_.check();
    const double scale = scale_.value();
    output_for(out_, 1);
    const MovingFrames frames(names_);
    const Output& output = output_for(out_, frames.paths().size() - 1);
    require_output(out_, frames.paths());
    Detector detector = detector_.detector(io::mesh_of(frames.first()));
    Recording recording{detector.mesh(), detector.options(), scale, {}, {}, {}};
    record(frames, detector, recording);
    output.write(out_, recording);
    report(recording);
    return kSuccess;
  }

 private:
  static void record(const MovingFrames& frames, Detector& detector, Recording& recording) {
    for (const std::filesystem::path& path : frames.paths())
      recording.names.push_back(utf8_text(path.filename().string()));
    recording.frames.push_back(frames.first().positions);
    Progress progress(frames.paths().size() - 1, "steps");
    for (std::size_t i = 1; i < frames.paths().size(); ++i) {
      recording.frames.push_back(frames.read(i));
      const std::vector<Point>& start = recording.frames[i - 1];
      std::vector<Point> end = recording.frames[i];
      scale_step(start, end, recording.scale);
      const std::vector<Contact>& contacts = detector.contacts({start, end});
      recording.steps.push_back({contacts, detector.statistics().stages});
      progress.show(i);
    }
    progress.clear();
  }

  void report(const Recording& recording) const {
    Tally total;
    for (const RecordedStep& step : recording.steps) total.add_counts(tally_of(step.contacts));
    const auto bytes = std::filesystem::is_regular_file(out_) ? std::filesystem::file_size(out_) : 0;
    if (json_)
      return print_json(
          {{"out", out_}, {"bytes", bytes}, {"steps", recording.steps.size()}, {"contacts", json_of(total)}});
    print_mesh(recording.mesh);
    fmt::print("contacts        {} vertex-face, {} edge-edge, of these {} unresolved, in {} {}\n", grouped(total.vf),
               grouped(total.ee), grouped(total.unresolved), recording.steps.size(),
               recording.steps.size() == 1 ? "step" : "steps");
    constexpr double kMegabyte = 1e6;
    fmt::print("written to      {} ({:.1f} MB)\n", printable(out_), static_cast<double>(bytes) / kMegabyte);
  }

  std::vector<std::string> names_;
  std::string out_ = "view.html";
  DetectorArguments detector_;
  ScaleArgument scale_;
  bool json_ = false;
};

}  // namespace

std::unique_ptr<Verb> make_view() { return std::make_unique<View>(); }

}  // namespace tamis::cli
