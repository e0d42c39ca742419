// The subdivision of a pair's path in time: a stack of undecided parts, the earliest on top. One pair may take seconds,
// so cancellation is checked every few parts.
#pragma once
#include <array>
#include <optional>
#include <vector>

#include "curves/paths/decide_path.hpp"
#include "curves/paths/path_reader.hpp"
#include "search/query/cancellation.hpp"

namespace tamis {

template <class T>
struct PathPart {
  Moment<T> from, to;
  std::array<double, 4> deviations{};  ///< set by PathParts::next
  double length() const { return to.time - from.time; }
};

template <class T>
class PathParts {
 public:
  /// Keeps references.
  PathParts(const PathQuestion& question, const PairReader& reader, const TimeInterval<double>& time)
      : question_(question), reader_(reader) {
    parts_.push_back({reader.at<T>(time.t_in), reader.at<T>(time.t_out)});
  }

  /// Takes the earliest undecided part; nothing if none is left. Throws Cancelled.
  std::optional<PathPart<T>> next() {
    constexpr int kPartsBetweenChecks = 64;  // some milliseconds at most
    if (parts_.empty()) return std::nullopt;
    if (taken_++ % kPartsBetweenChecks == 0) stop_if_cancelled(question_);
    PathPart<T> part = parts_.back();
    parts_.pop_back();
    part.deviations = reader_.deviations(part.from.time, part.to.time);
    return part;
  }
  int taken() const { return taken_; }

  /// Cuts a part in two. Returns false if `time` does not lie strictly within it.
  bool cut(const PathPart<T>& part, double time) {
    if (!(time > part.from.time && time < part.to.time)) return false;
    const Moment<T> moment = reader_.at<T>(time);
    parts_.push_back({moment, part.to});
    parts_.push_back({part.from, moment});
    return true;
  }

  /// Cuts a part in up to three, `middle` being one of them.
  void cut(const PathPart<T>& part, const TimeInterval<double>& middle) {
    const bool has_end = middle.t_out < part.to.time;
    const bool has_start = middle.t_in > part.from.time;
    const Moment<T> start = has_start ? reader_.at<T>(middle.t_in) : part.from;
    const Moment<T> end = has_end ? reader_.at<T>(middle.t_out) : part.to;
    if (has_end) parts_.push_back({end, part.to});
    parts_.push_back({start, end});
    if (has_start) parts_.push_back({part.from, start});
  }

 private:
  const PathQuestion& question_;
  const PairReader& reader_;
  std::vector<PathPart<T>> parts_;
  int taken_ = 0;
};

}  // namespace tamis
