#include "files/view/audit_page.hpp"

#include <algorithm>
#include <map>

#include "files/error.hpp"
#include "files/view/viewer_page.hpp"
#include "numbers/floating_point_state.hpp"

namespace tamis::io {
namespace {

using audit::FrameFindings;
using audit::FramePointer;

/// The mesh of the first kept frame that is not free, else of the first kept frame; null if none is kept.
std::shared_ptr<const audit::AuditedMesh> shown_mesh(const std::vector<FrameFindings>& kept) {
  const auto is_bad = [](const FrameFindings& findings) { return !findings.answer.is_free(); };
  const auto bad = std::find_if(kept.begin(), kept.end(), is_bad);
  if (kept.empty()) return nullptr;
  return (bad == kept.end() ? kept.front() : *bad).frame->mesh;
}

RecordedStrip strip_of(const audit::Report& report) {
  RecordedStrip strip;
  strip.asks_intersections = report.asks_intersections;
  for (const audit::FrameAnswer& frame : report.frames) {
    strip.names.push_back(frame.name);
    strip.problems.push_back(frame.problem);
    strip.has_step.push_back(frame.has_step);
    strip.fresh.push_back(frame.fresh);
    strip.collapsed.push_back(frame.has_collapsed);
    strip.contacts.push_back(frame.contacts());
    strip.intersections.push_back(frame.intersections());
    strip.steps.push_back(RecordedStrip::kNotShown);
  }
  return strip;
}

/// The note, if something has collapsed in the frame or was left out of the step to it.
std::string collapsed_in(const audit::FrameAnswer& answer) {
  const bool is_left_out = answer.has_step && answer.contacts() == 0 && answer.toi_lower < 1;
  return answer.has_collapsed || is_left_out ? answer.note : "";
}

std::string why_nothing_is_shown(const audit::Report& report) {
  const auto has_problem = [](const audit::FrameAnswer& frame) { return !frame.problem.empty(); };
  const auto first = std::find_if(report.frames.begin(), report.frames.end(), has_problem);
  if (first == report.frames.end()) return "no frame is there to be shown, as each is too large to keep: write csv";
  return fmt::format("no frame is there to be shown, as none could be used: the first, {}, has this problem: {}",
                     first->name, first->problem);
}

/// Adds each frame to the recording once, also if one step ends and another begins there.
class ShownFrames {
 public:
  explicit ShownFrames(Recording& recording) : recording_(recording) {}

  std::size_t place_of(const FramePointer& frame) {
    const auto [place, is_new] = places_.try_emplace(frame.get(), recording_.frames.size());
    if (is_new) {
      recording_.frames.push_back(frame->positions);
      recording_.names.push_back(frame->name);
    }
    return place->second;
  }

 private:
  Recording& recording_;
  std::map<const audit::Frame*, std::size_t> places_;
};

}  // namespace

void write_audit_page(const std::filesystem::path& path, const audit::Report& report) {
  const ComputingState state;
  const std::vector<FrameFindings>& kept = report.kept.frames();
  const auto mesh = shown_mesh(kept);
  if (!mesh) throw FileError(path.string(), "", why_nothing_is_shown(report));
  Options options;
  options.min_separation = report.min_separation;
  Recording recording{mesh->mesh(), options, 1, {}, {}, {}};
  recording.strip = strip_of(report);
  recording.objects = mesh->objects();
  ShownFrames frames(recording);
  for (const FrameFindings& findings : kept) {
    if (findings.frame->mesh != mesh) continue;
    recording.strip->steps[static_cast<std::size_t>(findings.number)] = static_cast<int>(recording.steps.size());
    const std::size_t start = frames.place_of(findings.before ? findings.before : findings.frame);
    const std::size_t end = frames.place_of(findings.frame);
    recording.steps.push_back({findings.contacts,
                               {},
                               {},
                               findings.intersections,
                               std::array{start, end},
                               0,
                               findings.is_new,
                               collapsed_in(findings.answer)});
  }
  write_viewer_page(path, recording);
}

}  // namespace tamis::io
