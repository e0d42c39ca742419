// tamis contacts; tamis-lab asks the same of detectors of its own.
#pragma once
#include "command/collapse_check.hpp"
#include "command/look_output.hpp"
#include "command/report.hpp"
#include "command/start_check.hpp"
#include "command/verbs/step_verb.hpp"

namespace tamis::cli {

class Contacts : public StepVerb {
 public:
  const char* name() const override { return "contacts"; }
  const char* summary() const override { return "All contacts of the step from START to END"; }
  const char* examples() const override {
    return "  tamis contacts cloth1.ply cloth2.ply\n"
           "  tamis contacts cloth1.ply cloth2.ply --out contacts.csv\n"
           "  tamis contacts cloth1.ply cloth2.ply --out contacts.html\n"
           "  tamis contacts cloth1.ply cloth2.ply --check-start\n"
           "  tamis contacts cloth1.ply cloth2.ply --scale 0.5 --json\n"
           "  tamis contacts cloth1.ply cloth2.ply --min-separation 1e-3 --repeat 9";
  }
  void declare(OptionList& options) override;
  int run() override;

 private:
  void write(const Detector& detector, const StepFiles& files, std::span<const Contact> contacts) const;
  void report(const Tally& tally, const CollapseCheck& collapse, const Detector& detector, const Timing& timing) const;

  StartCheck start_check_;
  LookOutput output_{"", io::NoExtension::is_first_format};
};

}  // namespace tamis::cli
