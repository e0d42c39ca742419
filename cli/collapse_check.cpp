#include "cli/collapse_check.hpp"

#include <fmt/format.h>

#include "audit/collapsed.hpp"
#include "cli/command_line/printable.hpp"
#include "cli/command_line/verb.hpp"

namespace tamis::cli {

void CollapseCheck::look(const std::string& name, const Mesh& mesh, const Positions& positions) {
  const audit::Collapsed collapsed = audit::collapsed_in(mesh, components_of(mesh), positions);
  if (collapsed.any()) facts_.push_back(fmt::format("{}: {}", name, collapsed.sentence));
}

int CollapseCheck::refuse(bool as_json) const {
  if (as_json) {
    print_json({{"free", false}, {"collapsed", facts_}});
    return kNo;
  }
  for (const std::string& fact : facts_) fmt::print("not free        {}\n", printable(fact));
  fmt::print("so every part of it touches every other, and no pairs are listed; mend this frame, or leave it out\n");
  return kNo;
}

}  // namespace tamis::cli
