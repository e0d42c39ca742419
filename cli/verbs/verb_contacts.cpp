// tamis contacts: all contacts of a step.
#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "cli/answers.hpp"
#include "cli/command_line/printable.hpp"
#include "cli/look_output.hpp"
#include "cli/verbs/step_verb.hpp"

namespace tamis::cli {
namespace {

class Contacts final : public StepVerb {
 public:
  const char* name() const override { return "contacts"; }
  const char* summary() const override { return "All contacts of the step from START to END"; }
  const char* examples() const override {
    return "  tamis contacts cloth1.ply cloth2.ply\n"
           "  tamis contacts cloth1.ply cloth2.ply --out contacts.csv\n"
           "  tamis contacts cloth1.ply cloth2.ply --out contacts.png --from -1,0.5,2\n"
           "  tamis contacts cloth1.ply cloth2.ply --scale 0.5 --json\n"
           "  tamis contacts cloth1.ply cloth2.ply --min-separation 1e-3 --repeat 9";
  }
  void declare(OptionList& options) override {
    StepVerb::declare(options);
    output_.declare(options);
  }

  int run() override {
    output_.require({start_, end_}, 1);
    StepFiles files = read();
    Detector detector = detector_for(std::move(files.mesh));
    const Step step = files.step();
    const std::vector<Contact>* contacts = nullptr;
    const Timing timing = ask_repeatedly(detector, repeat_, [&] { contacts = &detector.contacts(step, own()); });
    write(detector, files, *contacts);
    report(tally_of(*contacts), detector, timing);
    return kSuccess;
  }

 private:
  void write(const Detector& detector, const StepFiles& files, const std::vector<Contact>& contacts) const {
    if (output_.path().empty()) return;
    io::Recording recording{detector.mesh(), detector.options(), 1, {}, {files.start, files.end}, {}};
    for (const std::filesystem::path name : {start_, end_})
      recording.names.push_back(utf8_text(name.filename().string()));
    recording.steps.push_back({contacts, detector.statistics().stages});
    output_.write(recording);
  }

  void report(const Tally& tally, const Detector& detector, const Timing& timing) const {
    if (json_) {
      Json json;
      add_tally(json, tally);
      add_costs(json, detector, timing);
      return print_json(json);
    }
    print_mesh(detector.mesh());
    print_tally(tally);
    if (!output_.path().empty()) fmt::print("written to      {}\n", printable(output_.path()));
    print_costs(detector, timing, repeat_);
  }

  LookOutput output_{"", io::NoExtension::is_first_format};
};

}  // namespace

std::unique_ptr<Verb> make_contacts() { return std::make_unique<Contacts>(); }

}  // namespace tamis::cli
