// tamis view: a step, a sequence of them, or a single frame, in one HTML file.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "command/collapse_check.hpp"
#include "command/command_line/printable.hpp"
#include "command/look_output.hpp"
#include "command/progress.hpp"
#include "command/report.hpp"
#include "command/step_files.hpp"
#include "command/verbs/motion_verb.hpp"
#include "command/verbs/moving_frames.hpp"
#include "files/mesh/mesh_formats.hpp"
#include "files/scale_step.hpp"
#include "tamis/error.hpp"

namespace tamis::cli {
namespace {

class View final : public MotionVerb {
 public:
  const char* name() const override { return "view"; }
  const char* summary() const override {
    return "One HTML file that shows a step or a sequence with its contacts, or one frame with its intersections";
  }
  const char* examples() const override {
    return "  tamis view cloth1.ply cloth2.ply --out step.html\n"
           "  tamis view 'frames/cloth*.ply' --out film.html\n"
           "  tamis view cloth1.ply --out pose.html\n"
           "  tamis view cloth1.ply cloth2.ply --scale 10 --out step.glb";
  }
  void declare(OptionList& options) override {
    options
        .add_texts("FRAMES", names_,
                   "START END, or one frame, or more: files, folders or patterns of " + io::mesh_format_names() +
                       ", in natural order")
        .required();
    output_.declare(options);
    declare_motion(options);
    declare_json(options, json_);
  }

  int run() override {
    check();
    output_.check();
    const MovingFrames frames(names_, 1, weld_distance());
    frames.require_no_gap();
    output_.require(frames.paths(), frames.paths().size() - 1, json_);
    Detector detector = detector_for(io::mesh_of(frames.first()));
    if (frames.paths().size() == 1) require_no_step_options(detector.options());
    const io::Recording recording = frames.paths().size() == 1 ? pose_of(frames, detector) : steps_of(frames, detector);
    output_.write(recording);
    if (has_contacts(recording)) note_coincident(recording.mesh, recording.frames.front());
    report(recording);
    return kSuccess;
  }

 private:
  /// A single frame is asked for its intersections: these options would change nothing.
  void require_no_step_options(const Options& options) const {
    if (scale() == 1 && own().at_start == AtStart::report && options.min_separation == 0 && options.radii.empty())
      return;
    throw InvalidOptions(
        "--scale, --at-start, --min-separation and --radius are of steps, and a single frame is named: leave them out, "
        "or name two frames");
  }

  static io::Recording pose_of(const MovingFrames& frames, Detector& whole) {
    const std::vector<Point>& positions = frames.first().positions;
    const std::string name = frames.paths().front().string();
    UncollapsedAsker asker(whole);
    Detector* detector = asker.detector_for(name, name, {positions, positions});
    io::Recording recording =
        recording_of(whole, frames.paths().front(), positions,
                     detector ? detector->intersections(positions) : std::span<const Intersection>());
    if (detector) recording.pose->stages = detector->statistics().stages;
    recording.pose->collapsed = asker.collapse().text();
    return recording;
  }

  io::Recording steps_of(const MovingFrames& frames, Detector& whole) const {
    UncollapsedAsker asker(whole);
    io::Recording recording{whole.mesh(), whole.options(), scale(), {}, {}, {}};
    for (const std::filesystem::path& path : frames.paths())
      recording.names.push_back(utf8_text(path.filename().string()));
    recording.frames.push_back(frames.first().positions);
    recording.at_start = own().at_start;
    Progress progress(frames.paths().size() - 1, "steps");
    for (std::size_t i = 1; i < frames.paths().size(); ++i) {
      recording.frames.push_back(frames.read(i));
      const std::vector<Point>& start = recording.frames[i - 1];
      std::vector<Point> end = recording.frames[i];
      note_units(frames.paths()[i].string(), start, end);
      io::scale_step(start, end, recording.scale);
      Detector* detector = asker.detector_for(frames.paths()[i - 1].string(), frames.paths()[i].string(), {start, end});
      io::RecordedStep& recorded = recording.steps.emplace_back();
      recorded.collapsed = asker.collapse().text();
      if (detector)
        asked_of("the step to " + frames.paths()[i].string(), [&] {
          const auto found = detector->contacts({start, end}, own());
          recorded.contacts.assign(found.begin(), found.end());
          recorded.stages = detector->statistics().stages;
          recorded.ignored = detector->statistics().ignored;
        });
      progress.show(i);
    }
    progress.clear();
    return recording;
  }

  static bool has_contacts(const io::Recording& recording) {
    if (recording.pose) return !recording.pose->intersections.empty();
    return std::ranges::any_of(recording.steps, [](const auto& step) { return !step.contacts.empty(); });
  }

  void report(const io::Recording& recording) const {
    const std::filesystem::path& out = output_.path();
    Tally total;
    for (const io::RecordedStep& step : recording.steps) total.add_counts(tally_of(step.contacts));
    const auto bytes = std::filesystem::is_regular_file(out) ? std::filesystem::file_size(out) : 0;
    if (json_) {
      Json json{
          {"out", out.string()}, {"bytes", bytes}, {"steps", recording.steps.size()}, {"contacts", json_of(total)}};
      json["intersections"] = recording.pose ? Json(recording.pose->intersections.size()) : Json();
      return print_json(json);
    }
    print_mesh(recording.mesh);
    if (recording.pose)
      fmt::print("intersections   {}\n", grouped(recording.pose->intersections.size()));
    else
      fmt::print("contacts        {} vertex-face, {} edge-edge{}, in {}\n", grouped(total.vf), grouped(total.ee),
                 of_loose_points(total.ve, total.vv), counted(recording.steps.size(), "step"));
    constexpr double kMegabyte = 1e6;
    fmt::print("written to      {} ({:.1f} MB)\n", printable(out.string()), static_cast<double>(bytes) / kMegabyte);
  }

  std::vector<std::string> names_;
  LookOutput output_{"view.html", io::NoExtension::is_refused};
};

}  // namespace

std::unique_ptr<Verb> make_view() { return std::make_unique<View>(); }

}  // namespace tamis::cli
