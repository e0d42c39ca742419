#include "audit/report.hpp"

#include <algorithm>
#include <cmath>

#include "tamis/error.hpp"

namespace tamis::audit {

std::string_view name_of(Kind kind) {
  return kind == Kind::edge_face ? "ef" : tamis::name_of(static_cast<PairKind>(kind));
}

void require_sound(const Options& options) {
  constexpr Index kLongestPath = 1000;
  if (options.ring_limit < 1 || options.ring_limit > kLongestPath)
    throw InvalidOptions("the ring limit is " + std::to_string(options.ring_limit) + ": give one from 1 to 1000");
  if (!(options.min_separation >= 0) || !std::isfinite(options.min_separation))
    throw InvalidOptions("the minimum separation is " + std::to_string(options.min_separation) +
                         ": give a finite number >= 0");
  if (options.threads < 0)
    throw InvalidOptions("threads is " + std::to_string(options.threads) + ": give a number >= 0, 0 being all");
  if (!options.intersections && !options.contacts)
    throw InvalidOptions("intersections and contacts are both switched off: leave one of them on");
  if (!options.contacts && options.min_separation > 0)
    throw InvalidOptions(
        "a minimum separation is for contacts, and these are switched off: remove one of the two options");
}

bool Report::is_free() const {
  return !ended_by && problems + collapsed == 0 &&
         std::all_of(counts.begin(), counts.end(), [](auto count) { return count == 0; });
}

std::optional<std::size_t> Report::first_bad() const {
  const auto found =
      std::find_if(frames.begin(), frames.end(), [](const FrameAnswer& frame) { return frame.is_bad(); });
  if (found == frames.end()) return std::nullopt;
  return static_cast<std::size_t>(found - frames.begin());
}

std::optional<std::size_t> Report::first_new() const {
  const auto found = std::find_if(frames.begin(), frames.end(), [](const FrameAnswer& f) { return f.fresh > 0; });
  if (found == frames.end()) return std::nullopt;
  return static_cast<std::size_t>(found - frames.begin());
}

std::string Report::object_name(const Finding& pair, std::size_t feature) const {
  const auto is_later = [](std::size_t frame, const Segment& segment) { return frame < segment.first_frame; };
  const auto next = std::upper_bound(segments.begin(), segments.end(), static_cast<std::size_t>(pair.frame), is_later);
  return std::prev(next)->objects.name_of(pair.objects[feature]);
}

ReportBuilder::ReportBuilder(const Options& options) : listed_pairs_(options.listed_pairs) {
  report_.min_separation = options.min_separation;
  report_.asks_intersections = options.intersections;
  report_.ring_limit = options.ring_limit;
  report_.by_rings.assign(static_cast<std::size_t>(options.ring_limit) + 2, 0);
  report_.kept = KeptFrames(options.kept_bytes);
}

void ReportBuilder::add(FrameFindings&& findings) {
  if (findings.frame->mesh && findings.frame->mesh != mesh_) begin_segment(findings);
  count(findings);
  list(findings.pairs);
  report_.frames.push_back(findings.answer);
  report_.kept.add(std::move(findings));
}

void ReportBuilder::begin_segment(const FrameFindings& findings) {
  mesh_ = findings.frame->mesh;
  report_.segments.push_back({report_.frames.size(), {{}, mesh_->objects().names}});
}

void ReportBuilder::count(const FrameFindings& findings) {
  report_.steps += findings.answer.has_step ? 1 : 0;
  report_.problems += findings.answer.problem.empty() ? 0 : 1;
  report_.fresh += findings.answer.fresh;
  report_.collapsed += findings.answer.has_collapsed ? 1 : 0;
  for (std::size_t kind = 0; kind < kKinds; ++kind) report_.counts[kind] += findings.answer.counts[kind];
  for (const Finding& pair : findings.pairs)
    ++(pair.rings == kNotConnected ? report_.by_rings.back()
                                   : report_.by_rings[static_cast<std::size_t>(pair.rings) - 1]);
}

void ReportBuilder::list(const std::vector<Finding>& pairs) {
  const auto room =
      static_cast<std::size_t>(std::min<std::uint64_t>(listed_pairs_ - report_.pairs.size(), pairs.size()));
  report_.pairs.insert(report_.pairs.end(), pairs.begin(), pairs.begin() + static_cast<std::ptrdiff_t>(room));
  report_.pairs_left_out += pairs.size() - room;
}

}  // namespace tamis::audit
