// tamis step: how far the step may go.
#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "cli/report.hpp"
#include "cli/step_verb.hpp"

namespace tamis::cli {
namespace {

class StepLength final : public StepVerb {
 public:
  const char* name() const override { return "step"; }
  const char* summary() const override { return "The earliest contact: how far the step may go"; }
  const char* examples() const override {
    return "  tamis step cloth1.ply cloth2.ply\n"
           "  tamis step cloth1.ply cloth2.ply --scale 3 --json\n"
           "  tamis step cloth1.ply cloth2.ply --keep-distance 0.1";
  }

  void declare(CLI::App& app) override {
    StepVerb::declare(app);
    keep_distance_ =
        add_number(app, "--keep-distance", "F", fraction_, {.least = 0, .most = 1, .takes_most = false},
                   "how far the step may go so that every pair keeps at least F times its distance at START: the step "
                   "length for the line search of a barrier method");
  }

  int run() override {
    StepFiles files = read();
    Detector detector = detector_for(std::move(files.mesh));
    const Step step = files.step();
    if (keep_distance_->count() > 0) return keep_distance(detector, step);
    EarliestContact first;
    const Timing timing = ask_repeatedly(detector, repeat_, [&] { first = detector.earliest(step); });
    report(first, detector, timing);
    return kSuccess;
  }

 private:
  void report(const EarliestContact& first, const Detector& detector, const Timing& timing) const {
    if (json_) {
      Json json;
      add_bracket(json, !first.contact, first.toi_lower, first.toi_upper);
      json["contact"] = first.contact ? json_of(*first.contact) : Json();
      add_costs(json, detector, timing);
      return print_json(json);
    }
    print_mesh(detector.mesh());
    if (first.contact) {
      print_bracket(first.toi_lower, first.toi_upper,
                    first.toi_upper < 1 || first.contact->certainty == Certainty::certified);
      print_contact(*first.contact);
    } else {
      fmt::print("first contact   none: the whole step is free, proven\n");
    }
    print_costs(detector, timing, repeat_);
  }

  int keep_distance(Detector& detector, const Step& step) const {
    SafeStep safe;
    const Timing timing = ask_repeatedly(detector, repeat_, [&] { safe = detector.keep_distance(step, fraction_); });
    if (json_) {
      Json json{{"keep_distance", fraction_},
                {"step_lower", safe.lower},
                {"step_upper", safe.upper},
                {"pair", safe.pair ? json_of(*safe.pair) : Json()}};
      add_costs(json, detector, timing);
      print_json(json);
      return kSuccess;
    }
    print_mesh(detector.mesh());
    print_safe_step(safe, fraction_, detector.options().min_separation);
    print_costs(detector, timing, repeat_);
    return kSuccess;
  }

  double fraction_ = 0;
  CLI::Option* keep_distance_ = nullptr;
};

}  // namespace

std::unique_ptr<Verb> make_step() { return std::make_unique<StepLength>(); }

}  // namespace tamis::cli
