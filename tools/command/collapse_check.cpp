#include "command/collapse_check.hpp"

#include <fmt/format.h>

#include "command/command_line/messages.hpp"
#include "command/command_line/verb.hpp"
#include "command/step_files.hpp"

namespace tamis::cli {

void CollapseCheck::look(const std::string& name, const Positions& positions) {
  const audit::Collapsed collapsed = audit::collapsed_in(mesh_, components_, positions);
  if (!collapsed.any()) return;
  left_out_.resize(collapsed.components.size());
  for (std::size_t i = 0; i < left_out_.size(); ++i) left_out_[i] = left_out_[i] || collapsed.components[i];
  facts_.push_back(fmt::format("{}: {}", name, collapsed.sentence));
  if (name != last_noted_) note(facts_.back() + ", so its parts touch each other; mend this frame, or remove it");
  last_noted_ = name;
}

void CollapseCheck::clear() {
  left_out_.clear();
  facts_.clear();
}

std::string CollapseCheck::text() const { return fmt::format("{}", fmt::join(facts_, "; ")); }

void CollapseCheck::print() const {
  fmt::print(
      "collapsed       objects in the note are skipped: their pairs are not listed, and nothing is proven about "
      "them\n");
}

int CollapseCheck::refuse(bool as_json) const {
  if (!as_json) {
    print();
    return kNo;
  }
  Json json;
  add_to(json);
  print_json(json);
  return kNo;
}

Detector* UncollapsedAsker::detector_for(const std::string& start_name, const std::string& end_name, const Step& step) {
  collapse_.clear();
  collapse_.look(start_name, step.start);
  collapse_.look(end_name, step.end);
  if (collapse_.passes()) return &whole_;
  if (collapse_.left_out() != left_out_) {
    left_out_ = collapse_.left_out();
    part_.reset();
    if (std::optional<Mesh> rest = collapse_.rest()) part_.emplace(std::move(*rest), whole_.options());
  }
  return part_ ? &*part_ : nullptr;
}

void note_causes(const Mesh& mesh, const std::string& start_name, const Positions& start, const std::string& end_name,
                 const Positions& end) {
  CollapseCheck collapse(mesh);
  collapse.look(start_name, start);
  collapse.look(end_name, end);
  if (collapse.passes()) note_coincident(mesh, start);
}

}  // namespace tamis::cli
