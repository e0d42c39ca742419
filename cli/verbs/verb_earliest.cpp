// tamis earliest: how far the step may go.
#include <memory>

#include "cli/answers.hpp"
#include "cli/start_check.hpp"
#include "cli/verbs/step_verb.hpp"

namespace tamis::cli {
namespace {

class StepLength final : public StepVerb {
 public:
  const char* name() const override { return "step"; }
  const char* summary() const override { return "The earliest contact: how far the step may go"; }
  const char* examples() const override {
    return "  tamis earliest cloth1.ply cloth2.ply\n"
           "  tamis earliest cloth1.ply cloth2.ply --scale 3 --json\n"
           "  tamis safe-step cloth1.ply cloth2.ply --keep 0.1 --check-start";
  }

  void declare(OptionList& options) override {
    StepVerb::declare(options);
    kept_.declare(options);
    start_.declare(options);
  }

  int run() override {
    StepFiles files = read();
    Detector detector = detector_for(std::move(files.mesh));
    const Step step = files.step();
    if (!start_.passes(detector, step.start)) return start_.refuse(detector, json_, Json::object());
    if (kept_.is_asked()) return safe_step(detector, step);
    EarliestContact first;
    const Timing timing = ask_repeatedly(detector, repeat_, [&] { first = detector.earliest(step, own()); });
    report(first, detector, timing);
    return kSuccess;
  }

 private:
  void report(const EarliestContact& first, const Detector& detector, const Timing& timing) const {
    if (json_) {
      Json json;
      add_earliest(json, first);
      start_.add_to(json);
      add_costs(json, detector, timing);
      return print_json(json);
    }
    print_mesh(detector.mesh());
    print_earliest(first);
    if (!first.contact) start_.print();
    print_costs(detector, timing, repeat_);
  }

  int safe_step(Detector& detector, const Step& step) const {
    SafeStep safe;
    const Timing timing =
        ask_repeatedly(detector, repeat_, [&] { safe = detector.safe_step(step, kept_.fraction(), own()); });
    if (json_) {
      Json json;
      add_safe_step(json, safe, kept_.fraction());
      start_.add_to(json);
      add_costs(json, detector, timing);
      print_json(json);
      return kSuccess;
    }
    print_mesh(detector.mesh());
    print_safe_step(safe, kept_.fraction(), detector.options().min_separation);
    if (!safe.pair) start_.print();
    print_costs(detector, timing, repeat_);
    return kSuccess;
  }

  KeepArgument kept_;
  StartCheck start_;
};

}  // namespace

std::unique_ptr<Verb> make_step() { return std::make_unique<StepLength>(); }

}  // namespace tamis::cli
