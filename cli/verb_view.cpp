// tamis view: a step, or a sequence of them, in one HTML file.
#include <fmt/format.h>

#include <memory>

#include "cli/arguments.hpp"
#include "cli/look_output.hpp"
#include "cli/moving_frames.hpp"
#include "cli/printable.hpp"
#include "cli/progress.hpp"
#include "cli/report.hpp"
#include "cli/step_files.hpp"
#include "cli/verb.hpp"
#include "io/scale_step.hpp"

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
  void declare(OptionList& options) override {
    options
        .add_texts("FRAMES", names_, "START END, or more: files, folders or patterns of PLY or OBJ, in natural order")
        .required();
    output_.declare(options);
    detector_.declare(options);
    scale_.declare(options);
    declare_json(options, json_);
  }

  int run() override {
    detector_.check();
    const double scale = scale_.value();
    output_.check();
    const MovingFrames frames(names_);
    output_.require(frames.paths(), frames.paths().size() - 1);
    Detector detector = detector_.detector(io::mesh_of(frames.first()));
    io::Recording recording{detector.mesh(), detector.options(), scale, {}, {}, {}};
    record(frames, detector, recording);
    output_.write(recording);
    report(recording);
    return kSuccess;
  }

 private:
  static void record(const MovingFrames& frames, Detector& detector, io::Recording& recording) {
    for (const std::filesystem::path& path : frames.paths())
      recording.names.push_back(utf8_text(path.filename().string()));
    recording.frames.push_back(frames.first().positions);
    Progress progress(frames.paths().size() - 1, "steps");
    for (std::size_t i = 1; i < frames.paths().size(); ++i) {
      recording.frames.push_back(frames.read(i));
      const std::vector<Point>& start = recording.frames[i - 1];
      std::vector<Point> end = recording.frames[i];
      io::scale_step(start, end, recording.scale);
      const std::vector<Contact>& contacts = detector.contacts({start, end});
      recording.steps.push_back({contacts, detector.statistics().stages});
      progress.show(i);
    }
    progress.clear();
  }

  void report(const io::Recording& recording) const {
    const std::string& out = output_.path();
    Tally total;
    for (const io::RecordedStep& step : recording.steps) total.add_counts(tally_of(step.contacts));
    const auto bytes = std::filesystem::is_regular_file(out) ? std::filesystem::file_size(out) : 0;
    if (json_)
      return print_json(
          {{"out", out}, {"bytes", bytes}, {"steps", recording.steps.size()}, {"contacts", json_of(total)}});
    print_mesh(recording.mesh);
    fmt::print("contacts        {} vertex-face, {} edge-edge, of these {} unresolved, in {} {}\n", grouped(total.vf),
               grouped(total.ee), grouped(total.unresolved), recording.steps.size(),
               recording.steps.size() == 1 ? "step" : "steps");
    constexpr double kMegabyte = 1e6;
    fmt::print("written to      {} ({:.1f} MB)\n", printable(out), static_cast<double>(bytes) / kMegabyte);
  }

  std::vector<std::string> names_;
  LookOutput output_{"view.html", ""};
  DetectorArguments detector_;
  ScaleArgument scale_;
  bool json_ = false;
};

}  // namespace

std::unique_ptr<Verb> make_view() { return std::make_unique<View>(); }

}  // namespace tamis::cli
