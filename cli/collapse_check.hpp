// Meshes in which an object has collapsed: every part of it touches every other, so questions that list pairs say this
// one fact instead.
#pragma once
#include <string>
#include <vector>

#include "cli/report.hpp"
#include "tamis/mesh.hpp"
#include "tamis/positions.hpp"

namespace tamis::cli {

class CollapseCheck {
 public:
  /// Looks at one pose, which the user calls `name`.
  void look(const std::string& name, const Mesh& mesh, const Positions& positions);
  bool passes() const { return facts_.empty(); }
  /// Says what has collapsed, and that nothing was asked. Returns kNo.
  int refuse(bool as_json) const;

 private:
  std::vector<std::string> facts_;
};

}  // namespace tamis::cli
