// tamis free: is the step free of contacts? The exit code says so.
#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "cli/report.hpp"
#include "cli/step_verb.hpp"

namespace tamis::cli {
namespace {

class Free final : public StepVerb {
 public:
  const char* name() const override { return "free"; }
  const char* summary() const override {
    return "Is the step free of contacts? Exit code 0: free, 1: contact, 2: error";
  }
  const char* examples() const override {
    return "  tamis free cloth1.ply cloth2.ply && echo may go\n"
           "  tamis free cloth1.ply cloth2.ply --min-separation 1e-3 --json";
  }

  int run() override {
    StepFiles files = read();
    Detector detector = detector_for(std::move(files.mesh));
    const Step step = files.step();
    bool is_free = false;
    const Timing timing = ask_repeatedly(detector, repeat_, [&] { is_free = detector.is_free(step); });
    if (json_) {
      Json json{{"free", is_free}};
      add_costs(json, detector, timing);
      print_json(json);
    } else {
      print_mesh(detector.mesh());
      fmt::print("{}\n", is_free ? "free            no contact during the step, proven"
                                 : "not free        there is a contact ('tamis step' tells where)");
      print_costs(detector, timing, repeat_);
    }
    return is_free ? kSuccess : kNo;
  }
};

}  // namespace

std::unique_ptr<Verb> make_free() { return std::make_unique<Free>(); }

}  // namespace tamis::cli
