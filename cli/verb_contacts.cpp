// tamis contacts: all contacts of a step.
#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "cli/output_file.hpp"
#include "cli/printable.hpp"
#include "cli/report.hpp"
#include "cli/step_verb.hpp"
#include "cli/view/outputs.hpp"

namespace tamis::cli {
namespace {

class Contacts final : public StepVerb {
 public:
  const char* name() const override { return "contacts"; }
  const char* summary() const override { return "All contacts of the step from START to END"; }
  const char* examples() const override {
    return "  tamis contacts cloth1.ply cloth2.ply\n"
           "  tamis contacts cloth1.ply cloth2.ply --out contacts.csv\n"
           "  tamis contacts cloth1.ply cloth2.ply --guarantee conservative --json\n"
           "  tamis contacts cloth1.ply cloth2.ply --min-separation 1e-3 --repeat 9";
  }
  void declare(CLI::App& app) override {
    StepVerb::declare(app);
    declare_output(
        app, out_,
        fmt::format("write the contacts to a file: {}; CSV if the extension is none of these", output_extensions()));
  }

  int run() override {
    require_output(out_, {start_, end_});
    StepFiles files = read();
    Detector detector = detector_for(std::move(files.mesh));
    const Step step = files.step();
    const std::vector<Contact>* contacts = nullptr;
    const Timing timing = ask_repeatedly(detector, repeat_, [&] { contacts = &detector.contacts(step); });
    if (!out_.empty()) write(detector, files, *contacts);
    report(tally_of(*contacts), detector, timing);
    return kSuccess;
  }

 private:
  void write(const Detector& detector, const StepFiles& files, const std::vector<Contact>& contacts) const {
    Recording recording{detector.mesh(), detector.options(), 1, {}, {files.start, files.end}, {}};
    for (const std::filesystem::path name : {start_, end_})
      recording.names.push_back(utf8_text(name.filename().string()));
    recording.steps.push_back({contacts, detector.statistics().stages});
    const Output* output = find_output(out_);
    (output ? *output : output_for("contacts.csv", 1)).write(out_, recording);
  }

  void report(const Tally& tally, const Detector& detector, const Timing& timing) const {
    if (json_) {
      Json json{{"contacts", json_of(tally)}};
      add_bracket(json, tally.is_free(), tally.toi_lower, tally.toi_upper);
      add_costs(json, detector, timing);
      return print_json(json);
    }
    print_mesh(detector.mesh());
    const std::string loose = tally.ve + tally.vv > 0 ? fmt::format(", {} vertex-edge, {} vertex-vertex",
                                                                    grouped(tally.ve), grouped(tally.vv))
                                                      : "";
    fmt::print("contacts        {} vertex-face, {} edge-edge{}, of these {} unresolved\n", grouped(tally.vf),
               grouped(tally.ee), loose, grouped(tally.unresolved));
    if (tally.is_free())
      fmt::print("first contact   none: the step is free, proven\n");
    else
      print_bracket(tally.toi_lower, tally.toi_upper, tally.unresolved < tally.contacts());
    if (!out_.empty()) fmt::print("written to      {}\n", printable(out_));
    print_costs(detector, timing, repeat_);
  }

  std::string out_;
};

}  // namespace

std::unique_ptr<Verb> make_contacts() { return std::make_unique<Contacts>(); }

}  // namespace tamis::cli
