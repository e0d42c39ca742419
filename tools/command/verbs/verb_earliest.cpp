// tamis earliest: the first contact of a step.
#include <memory>
#include <optional>

#include "command/answers.hpp"
#include "command/collapse_check.hpp"
#include "command/start_check.hpp"
#include "command/verbs/step_verb.hpp"

namespace tamis::cli {
namespace {

class Earliest final : public StepVerb {
 public:
  const char* name() const override { return "earliest"; }
  const char* summary() const override { return "The earliest contact: how far the step may go"; }
  const char* examples() const override {
    return "  tamis earliest cloth1.ply cloth2.ply\n"
           "  tamis earliest cloth1.ply cloth2.ply --scale 3 --json\n"
           "  tamis earliest cloth1.ply cloth2.ply --check-start";
  }

  void declare(OptionList& options) override {
    StepVerb::declare(options);
    start_.declare(options);
  }

  int run() override {
    StepFiles files = read();
    CollapseCheck collapse(files.mesh);
    collapse.look(StepVerb::start_.string(), files.start);
    collapse.look(end_.string(), files.end);
    Options options = options_for(files.mesh);
    std::optional<Mesh> asked = collapse.passes() ? std::move(files.mesh) : collapse.rest();
    if (!asked) return collapse.refuse(json_);
    Detector detector = detector_for(std::move(*asked), std::move(options));
    const Step step = files.step();
    if (!start_.passes(detector, step.start)) return start_.refuse(detector, json_, Json::object());
    EarliestContact first;
    const Timing timing = ask_repeatedly(detector, repeat_, [&] { first = detector.earliest(step, own()); });
    if (first.contact && collapse.passes()) note_coincident(detector.mesh(), step.start);
    report(first, collapse, detector, timing);
    return collapse.passes() ? kSuccess : kNo;
  }

 private:
  void report(const EarliestContact& first, const CollapseCheck& collapse, const Detector& detector,
              const Timing& timing) const {
    if (json_) {
      Json json;
      add_earliest(json, first, collapse.passes());
      if (!collapse.passes()) collapse.add_to(json);
      start_.add_to(json);
      add_costs(json, detector, timing);
      return print_json(json);
    }
    print_asked(detector);
    print_earliest(first, collapse.passes());
    if (!collapse.passes()) collapse.print();
    print_ignored(detector.statistics());
    if (!first.contact && collapse.passes()) start_.print();
    print_costs(detector.statistics(), timing, repeat_);
  }

  StartCheck start_;
};

}  // namespace

std::unique_ptr<Verb> make_earliest() { return std::make_unique<Earliest>(); }

}  // namespace tamis::cli
