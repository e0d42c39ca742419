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
           "  tamis step cloth1.ply cloth2.ply --scale 3 --json";
  }

  int run() override {
    StepFiles files = read();
    Detector detector(std::move(files.mesh), options());
    const Step step = files.step();
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
};

}  // namespace

std::unique_ptr<Verb> make_step() { return std::make_unique<StepLength>(); }

}  // namespace tamis::cli
