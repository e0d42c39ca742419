// Objects that have collapsed (tools/audit/collapsed.hpp). One rule for all verbs: a note names them where the answer
// is no. Verbs that answer with pairs leave these objects out, as every part of them may touch every other, and end
// with exit code 1.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "audit/collapsed.hpp"
#include "command/report.hpp"
#include "tamis/mesh.hpp"
#include "tamis/positions.hpp"

namespace tamis::cli {

/// What has collapsed in the poses of a question.
class CollapseCheck {
 public:
  /// Keeps a reference.
  explicit CollapseCheck(const Mesh& mesh) : mesh_(mesh), components_(components_of(mesh)) {}

  /// Looks at one pose, which the user calls `name`. Notes on stderr what has collapsed in it, unless it was the pose
  /// looked at last with this name.
  void look(const std::string& name, const Positions& positions);
  /// Begins another question.
  void clear();

  bool passes() const { return left_out_.empty(); }
  /// By component; empty if none is left out.
  const std::vector<bool>& left_out() const { return left_out_; }
  /// The mesh without what has collapsed; nothing if no feature is left.
  std::optional<Mesh> rest() const { return audit::without(mesh_, components_, left_out_); }
  /// What has collapsed, in one line; empty if nothing has.
  std::string text() const;

  /// Says that the answer is about the rest alone.
  void print() const;
  /// Adds the key `collapsed`.
  void add_to(Json& json) const { json["collapsed"] = facts_; }
  /// Answers a question of which nothing is left. Returns kNo.
  int refuse(bool as_json) const;

 private:
  const Mesh& mesh_;
  Components components_;
  std::vector<bool> left_out_;
  std::vector<std::string> facts_;
  std::string last_noted_;
};

/// Asks about many steps of one mesh, each without what has collapsed at its ends.
class UncollapsedAsker {
 public:
  /// Keeps a reference.
  explicit UncollapsedAsker(Detector& whole) : whole_(whole), collapse_(whole.mesh()) {}

  /// The detector to ask about this step: the given one, or one of a part of the mesh with the same vertices. Null if
  /// nothing is left to ask about. Valid until the next call.
  Detector* detector_for(const std::string& start_name, const std::string& end_name, const Step& step);
  /// What has collapsed in the step of the last call.
  const CollapseCheck& collapse() const { return collapse_; }

 private:
  Detector& whole_;
  CollapseCheck collapse_;
  std::vector<bool> left_out_;  ///< what `part_` does not know
  std::optional<Detector> part_;
};

/// Notes on stderr what explains a contact in a step: what has collapsed at one of its ends, else vertices that lie on
/// each other at its start.
void note_causes(const Mesh& mesh, const std::string& start_name, const Positions& start, const std::string& end_name,
                 const Positions& end);

}  // namespace tamis::cli
