#include "audit/kept_frames.hpp"

#include <algorithm>
#include <climits>

namespace tamis::audit {
namespace {

std::size_t bytes_of(const FramePointer& frame) { return frame ? frame->positions.size() * sizeof(Point) : 0; }

/// Counts the frame before, even if that frame is kept as well: at most twice the memory that is taken.
std::size_t bytes_of(const FrameFindings& findings) {
  return sizeof(FrameFindings) + bytes_of(findings.before) + bytes_of(findings.frame) +
         findings.contacts.size() * sizeof(Contact) + findings.intersections.size() * sizeof(Intersection) +
         findings.is_new.size() / CHAR_BIT;
}

}  // namespace

void KeptFrames::add(FrameFindings&& findings) {
  const bool is_free = findings.answer.is_free();
  const std::size_t bytes = bytes_of(findings);
  if (!findings.answer.problem.empty() || bytes > most_bytes_ || (is_free && findings.number % stride_ != 0)) return;
  while (bytes_ + bytes > most_bytes_)
    if (!thin_out()) return;
  if (is_free && findings.number % stride_ != 0) return;
  bytes_ += bytes;
  findings.pairs = {};  // the report lists them
  frames_.push_back(std::move(findings));
}

bool KeptFrames::thin_out() {
  const auto is_free = [](const FrameFindings& f) { return f.answer.is_free() && f.number > 0; };
  if (std::none_of(frames_.begin(), frames_.end(), is_free)) return false;
  stride_ *= 2;
  std::erase_if(frames_, [&](const FrameFindings& f) { return is_free(f) && f.number % stride_ != 0; });
  bytes_ = 0;
  for (const FrameFindings& f : frames_) bytes_ += bytes_of(f);
  return true;
}

}  // namespace tamis::audit
