// The answer to an audit.
#pragma once
#include <exception>
#include <optional>
#include <vector>

#include "audit/findings.hpp"
#include "audit/kept_frames.hpp"
#include "audit/options.hpp"

namespace tamis::audit {

/// Frames that follow each other with one topology.
struct Segment {
  std::size_t first_frame;
  Objects objects;  ///< names alone
};

struct Report {
  double min_separation = 0;
  bool asks_intersections = true;
  Index ring_limit = 0;
  std::vector<Segment> segments;
  std::vector<FrameAnswer> frames;  ///< those that were asked about, in their order
  std::vector<Finding> pairs;       ///< the first ones, by frame
  std::uint64_t pairs_left_out = 0;
  /// How many of all pairs are 1, 2, ... edges apart up to the limit; how many are farther apart; how many are not
  /// connected.
  std::vector<std::uint64_t> by_rings;
  std::array<std::uint64_t, kKinds> counts{};
  std::uint64_t fresh = 0;      ///< of these, pairs that are new since the frame before
  std::uint64_t steps = 0;      ///< that were asked about
  std::uint64_t problems = 0;   ///< frames that could not be asked about
  std::uint64_t collapsed = 0;  ///< frames with objects that have collapsed
  KeptFrames kept;
  /// The exception that ended the audit before the source did; null if there was none.
  std::exception_ptr ended_by;

  /// Nothing was found, and all could be asked about.
  bool is_free() const;
  /// The first frame with an intersection or a collapsed object, or at which a step with contacts ends.
  std::optional<std::size_t> first_bad() const;
  /// The first frame with a pair that is new since the frame before.
  std::optional<std::size_t> first_new() const;
  std::string object_name(const Finding& pair, std::size_t feature) const;
};

/// Puts a report together, frame by frame.
class ReportBuilder {
 public:
  explicit ReportBuilder(const Options& options);

  void add(FrameFindings&& findings);
  Report& report() { return report_; }

 private:
  void begin_segment(const FrameFindings& findings);
  void count(const FrameFindings& findings);
  void list(const std::vector<Finding>& pairs);

  std::uint64_t listed_pairs_;
  std::shared_ptr<const AuditedMesh> mesh_;
  Report report_;
};

}  // namespace tamis::audit
