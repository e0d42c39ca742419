// tamis contacts: all contacts of a step.
#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <optional>
#include <span>

#include "command/answers.hpp"
#include "command/command_line/printable.hpp"
#include "command/verbs/contacts.hpp"

namespace tamis::cli {

void Contacts::declare(OptionList& options) {
  StepVerb::declare(options);
  start_check_.declare(options);
  output_.declare(options);
}

int Contacts::run() {
  output_.require({start_, end_}, 1, json_);
  StepFiles files = read();
  CollapseCheck collapse(files.mesh);
  collapse.look(start_.string(), files.start);
  collapse.look(end_.string(), files.end);
  Options options = options_for(files.mesh);
  std::optional<Mesh> asked = collapse.passes() ? std::move(files.mesh) : collapse.rest();
  if (!asked) return collapse.refuse(json_);
  Detector detector = detector_for(std::move(*asked), std::move(options));
  const Step step = files.step();
  if (!start_check_.passes(detector, step.start)) return start_check_.refuse(detector, json_, Json::object());
  std::span<const Contact> contacts;
  const Timing timing = ask_repeatedly(detector, repeat_, [&] { contacts = detector.contacts(step, own()); });
  if (!contacts.empty() && collapse.passes()) note_coincident(detector.mesh(), step.start);
  write(detector, files, contacts);
  report(tally_of(contacts), collapse, detector, timing);
  return collapse.passes() ? kSuccess : kNo;
}

void Contacts::write(const Detector& detector, const StepFiles& files, std::span<const Contact> contacts) const {
  if (output_.path().empty()) return;
  io::Recording recording{detector.mesh(), detector.options(), 1, {}, {files.start, files.end}, {}};
  for (const std::filesystem::path& name : {start_, end_})
    recording.names.push_back(utf8_text(name.filename().string()));
  recording.at_start = own().at_start;
  recording.steps.push_back({{contacts.begin(), contacts.end()}, detector.statistics().stages});
  recording.steps.back().ignored = detector.statistics().ignored;
  output_.write(recording);
}

void Contacts::report(const Tally& tally, const CollapseCheck& collapse, const Detector& detector,
                      const Timing& timing) const {
  if (json_) {
    Json json;
    add_tally(json, tally, collapse.passes());
    if (!collapse.passes()) collapse.add_to(json);
    start_check_.add_to(json);
    add_costs(json, detector, timing);
    return print_json(json);
  }
  print_asked(detector);
  print_tally(tally, collapse.passes());
  if (!collapse.passes()) collapse.print();
  print_ignored(detector.statistics());
  if (tally.is_free() && collapse.passes()) start_check_.print();
  if (!output_.path().empty()) fmt::print("written to      {}\n", printable(output_.path().string()));
  print_costs(detector.statistics(), timing, repeat_);
}

std::unique_ptr<Verb> make_contacts() { return std::make_unique<Contacts>(); }

}  // namespace tamis::cli
