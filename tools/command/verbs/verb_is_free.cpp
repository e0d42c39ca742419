// tamis is-free: is the step free of contacts, is every step of a sequence? The exit code says so.
#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <optional>

#include "command/answers.hpp"
#include "command/collapse_check.hpp"
#include "command/command_line/printable.hpp"
#include "command/progress.hpp"
#include "command/start_check.hpp"
#include "command/verbs/motion_verb.hpp"
#include "command/verbs/sequence_steps.hpp"
#include "files/mesh/mesh_formats.hpp"

namespace tamis::cli {
namespace {

class IsFree final : public MotionVerb {
 public:
  const char* name() const override { return "is-free"; }
  const char* summary() const override {
    return "Is the step, or each step of a sequence, free of contacts? Exit code 0: free, 1: contact, 2: error";
  }
  const char* examples() const override {
    return "  tamis is-free cloth1.ply cloth2.ply && echo may go\n"
           "  tamis is-free cloth1.ply cloth2.ply --check-start --json\n"
           "  tamis is-free 'frames/cloth*.ply' --min-separation 1e-3";
  }

  void declare(OptionList& options) override {
    options
        .add_texts(
            "FRAMES", names_,
            "START END, or more: files, folders or patterns of " + io::mesh_format_names() + ", in natural order")
        .required();
    declare_motion(options);
    start_.declare(options);
    declare_repeat(options, repeat_);
    declare_json(options, json_);
  }

  int run() override {
    check();
    const MovingFrames frames(names_, 2, weld_distance());
    frames.note_gaps();
    Detector detector = detector_for(io::mesh_of(frames.first()));
    if (!start_.passes(detector, frames.first().positions)) return start_.refuse(detector, json_, {{"free", false}});
    Timing timing;
    const std::optional<std::size_t> met = ask(frames, detector, timing);
    report(frames, met, detector, timing);
    return met ? kNo : kSuccess;
  }

 private:
  /// The frame at the end of the first step that is not free; none if all are free.
  std::optional<std::size_t> ask(const MovingFrames& frames, Detector& detector, Timing& timing) const {
    std::optional<std::size_t> met;
    Progress progress(frames.paths().size() - 1, "steps");
    for_each_step(frames, {1, frames.paths().size(), 1, scale()}, [&](std::size_t end, int /*part*/, const Step& step) {
      bool is_free = false;
      timing += ask_repeatedly(detector, repeat_, [&] { is_free = detector.is_free(step, own()); });
      if (!is_free) {
        met = end;
        progress.clear();
        note_causes(detector.mesh(), frames.paths()[end - 1].string(), step.start, frames.paths()[end].string(),
                    step.end);
      }
      progress.show(end);
      return is_free;
    });
    progress.clear();
    return met;
  }

  void report(const MovingFrames& frames, const std::optional<std::size_t>& met, const Detector& detector,
              const Timing& timing) const {
    if (json_) {
      Json json{{"free", !met}, {"steps", frames.step_count()}, {"first_not_free", step_to(frames, met)}};
      start_.add_to(json);
      add_costs(json, detector, timing);
      return print_json(json);
    }
    print_asked(detector);
    const std::size_t steps = frames.step_count();
    print_free(!met, steps == 1 ? "the step" : fmt::format("any of {} steps", grouped(steps)));
    if (met && steps > 1)
      fmt::print("first           in step {}, to {}; later steps were not tested\n", *met,
                 printable(frames.paths()[*met].string()));
    if (steps == 1) print_ignored(detector.statistics());
    if (!met) start_.print();
    print_costs(detector.statistics(), timing, repeat_);
  }

  static Json step_to(const MovingFrames& frames, const std::optional<std::size_t>& end) {
    if (!end) return nullptr;
    return {{"start", frames.paths()[*end - 1].string()}, {"end", frames.paths()[*end].string()}};
  }

  std::vector<std::string> names_;
  int repeat_ = 1;
  StartCheck start_;
};

}  // namespace

std::unique_ptr<Verb> make_is_free() { return std::make_unique<IsFree>(); }

}  // namespace tamis::cli
