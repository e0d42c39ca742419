#include "audit/frame_asker.hpp"

#include <algorithm>
#include <cmath>

#include "audit/doubts.hpp"

namespace tamis::audit {
namespace {

bool is_finite(const Point& p) { return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]); }

/// Is it one vertex, three times?
bool is_point(const Face& face) { return face[0] == face[1] && face[1] == face[2]; }

/// The number of vertices of the first feature.
std::size_t first_size(Kind kind) { return kind == Kind::edge_edge || kind == Kind::edge_face ? 2 : 1; }

std::size_t used(const std::array<Index, 4>& vertices) {
  return static_cast<std::size_t>(std::find(vertices.begin(), vertices.end(), -1) - vertices.begin());
}

bool is_usable(const FramePointer& frame) { return frame && problem_of(*frame).empty(); }

void add_sentence(std::string& note, const std::string& sentence) {
  if (!sentence.empty()) note += (note.empty() ? "" : "; ") + sentence;
}

/// Empty if both are.
std::vector<bool> in_either(std::vector<bool> a, const std::vector<bool>& b) {
  if (a.empty()) return b;
  for (std::size_t i = 0; i < b.size(); ++i) a[i] = a[i] || b[i];
  return a;
}

void bracket_first(FrameAnswer& answer, std::span<const Contact> contacts) {
  for (const Contact& c : contacts) {
    answer.toi_lower = std::min(answer.toi_lower, c.toi_lower);
    answer.toi_upper = std::min(answer.toi_upper, c.toi_upper);
  }
}

}  // namespace

std::string problem_of(const Frame& frame) {
  if (!frame.problem.empty()) return frame.problem;
  const auto expected = static_cast<std::size_t>(frame.mesh->mesh().vertex_count());
  if (frame.positions.size() != expected)
    return "it has " + std::to_string(frame.positions.size()) + " vertices, the mesh " + std::to_string(expected) +
           ": give a row for each vertex";
  for (const Index v : frame.mesh->mesh().points())
    if (!is_finite(frame.positions[static_cast<std::size_t>(v)]))
      return "vertex " + std::to_string(v) +
             " is not finite: nothing can be said of this frame, nor of steps to and from it";
  return {};
}

FrameAsker::FrameAsker(const Options& options, int threads, std::function<bool()> is_cancelled)
    : options_(options), threads_(threads), is_cancelled_(std::move(is_cancelled)) {}

FrameFindings FrameAsker::ask(const FramePointer& before, const FramePointer& frame, std::int64_t number) {
  FrameFindings findings{number, nullptr, frame, {frame->name, problem_of(*frame), frame->note}, {}, {}, {}, {}};
  if (!findings.answer.problem.empty()) return findings;
  const Collapsed here = collapsed_in_frame(frame);
  findings.answer.has_collapsed = here.any();
  if (here.any()) add_sentence(findings.answer.note, here.sentence + ": nothing else of it is tested in this frame");
  if (before && before->mesh && before->mesh != frame->mesh)
    add_sentence(findings.answer.note, "the topology changes here: no step leads to this frame");
  else if (options_.contacts && frame->follows && is_usable(before))
    findings.before = before;
  const bool is_first = !before || before->mesh != frame->mesh;
  if (is_first) add_sentence(findings.answer.note, doubt_about_coincidence(frame->mesh->mesh(), frame->positions));
  if (findings.before)
    add_sentence(findings.answer.note, doubt_about_units(findings.before->positions, frame->positions));
  std::vector<bool> left_out = here.components;
  if (findings.before) {
    const Collapsed then = collapsed_in_frame(before);
    if (then.any()) add_sentence(findings.answer.note, "the step skips objects that have collapsed at its start");
    left_out = in_either(left_out, then.components);
  }
  if (!left_out.empty()) findings.answer.toi_lower = 0;  // nothing is proven of what is left out
  if (!use(frame->mesh, left_out)) findings.before = nullptr;
  if (findings.before) ask_step(findings);
  if (options_.intersections && use(frame->mesh, here.components)) ask_pose(findings);
  list(findings);
  return findings;
}

Collapsed FrameAsker::collapsed_in_frame(const FramePointer& frame) const {
  return collapsed_in(frame->mesh->mesh(), frame->mesh->components(), frame->positions);
}

bool FrameAsker::use(const std::shared_ptr<const AuditedMesh>& mesh, std::vector<bool> left_out) {
  if (mesh == mesh_ && left_out == left_out_) return detector_.has_value();
  tamis::Options options;
  options.threads = threads_;
  options.min_separation = options_.min_separation;
  options.is_cancelled = is_cancelled_;
  detector_.reset();
  free_frame_ = nullptr;
  if (left_out.empty())
    detector_.emplace(mesh->mesh(), std::move(options));
  else if (const auto rest = without(mesh->mesh(), mesh->components(), left_out))
    detector_.emplace(*rest, std::move(options));
  left_out_ = std::move(left_out);
  if (mesh == mesh_) return detector_.has_value();
  mesh_ = mesh;
  has_point_face_ = std::any_of(mesh->mesh().faces().begin(), mesh->mesh().faces().end(), is_point);
  rings_.emplace(*mesh_, options_.ring_limit);
  return detector_.has_value();
}

void FrameAsker::ask_step(FrameFindings& findings) {
  const auto found = detector_->contacts({findings.before->positions, findings.frame->positions});
  findings.contacts.assign(found.begin(), found.end());
  findings.answer.has_step = true;
  bracket_first(findings.answer, findings.contacts);
}

/// A step without contacts from a frame without intersections leads to another such frame, so the question is left out:
/// an edge first touches a face with an end, or at an edge of the face, and both are contacts. The exception is a face
/// of one vertex, which has no edge: a triangle with this vertex can flatten until its opposite side meets the vertex.
void FrameAsker::ask_pose(FrameFindings& findings) {
  const bool is_led_to =
      !has_point_face_ && findings.before && findings.before == free_frame_ && findings.contacts.empty();
  if (!is_led_to) {
    const auto found = detector_->intersections(findings.frame->positions);
    findings.intersections.assign(found.begin(), found.end());
  }
  free_frame_ = findings.intersections.empty() ? findings.frame : nullptr;
}

void FrameAsker::list(FrameFindings& findings) {
  const std::int64_t number = findings.number;
  findings.pairs.reserve(findings.intersections.size() + findings.contacts.size());
  for (const Intersection& i : findings.intersections)
    findings.pairs.push_back(finding(number, Kind::edge_face, i.edge, i.face));
  for (const Contact& c : findings.contacts) {
    const auto kind = static_cast<Kind>(c.kind);
    const auto vertices = std::span(c.vertices).first(used(c.vertices));
    const std::size_t first = first_size(kind);
    findings.pairs.push_back(finding(number, kind, vertices.first(first), vertices.subspan(first)));
    findings.pairs.back().toi_lower = c.toi_lower;
    findings.pairs.back().toi_upper = c.toi_upper;
  }
  for (const Finding& pair : findings.pairs) {
    ++findings.answer.counts[static_cast<std::size_t>(pair.kind)];
    findings.answer.neighbours += pair.rings == 1 ? 1 : 0;
  }
}

Finding FrameAsker::finding(std::int64_t number, Kind kind, std::span<const Index> first,
                            std::span<const Index> second) {
  std::array<Index, 5> vertices;
  vertices.fill(-1);
  std::copy(second.begin(), second.end(), std::copy(first.begin(), first.end(), vertices.begin()));
  const std::array objects{mesh_->object_of(first.front()), mesh_->object_of(second.front())};
  return {number, kind, vertices, 1, 1, objects, rings_->between(first, second), false};
}

}  // namespace tamis::audit
