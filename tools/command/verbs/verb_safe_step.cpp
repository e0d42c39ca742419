// tamis safe-step: how far a step may go so that every pair keeps a part of its distance.
#include <memory>

#include "command/answers.hpp"
#include "command/collapse_check.hpp"
#include "command/start_check.hpp"
#include "command/verbs/step_verb.hpp"

namespace tamis::cli {
namespace {

class SafeStepLength final : public StepVerb {
 public:
  const char* name() const override { return "safe-step"; }
  const char* summary() const override {
    return "How far the step may go while every pair keeps a part of its distance: for a barrier's line search";
  }
  const char* examples() const override {
    return "  tamis safe-step cloth1.ply cloth2.ply\n"
           "  tamis safe-step cloth1.ply cloth2.ply --keep 0.5 --min-separation 1e-3 --json\n"
           "  tamis safe-step cloth1.ply cloth2.ply --check-start";
  }

  void declare(OptionList& options) override {
    StepVerb::declare(options);
    keep_.declare(options);
    start_.declare(options);
  }

  int run() override {
    StepFiles files = read();
    Detector detector = detector_for(std::move(files.mesh));
    const Step step = files.step();
    if (!start_.passes(detector, step.start)) return start_.refuse(detector, json_, Json::object());
    SafeStep safe;
    const Timing timing =
        ask_repeatedly(detector, repeat_, [&] { safe = detector.safe_step(step, keep_.part(), own()); });
    if (safe.toi_lower < 1)
      note_causes(detector.mesh(), StepVerb::start_.string(), step.start, end_.string(), step.end);
    report(safe, detector, timing);
    return kSuccess;
  }

 private:
  void report(const SafeStep& safe, const Detector& detector, const Timing& timing) const {
    if (json_) {
      Json json;
      add_safe_step(json, safe, keep_.part());
      start_.add_to(json);
      add_costs(json, detector, timing);
      return print_json(json);
    }
    print_asked(detector);
    print_safe_step(safe, keep_.part(), detector.options().min_separation);
    print_ignored(detector.statistics());
    if (!safe.pair) start_.print();
    print_costs(detector.statistics(), timing, repeat_);
  }

  KeepArgument keep_;
  StartCheck start_;
};

}  // namespace

std::unique_ptr<Verb> make_safe_step() { return std::make_unique<SafeStepLength>(); }

}  // namespace tamis::cli
