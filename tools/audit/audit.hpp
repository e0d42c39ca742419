// Is a recorded motion free, and if not, where?
#pragma once
#include "audit/frame_source.hpp"
#include "audit/options.hpp"
#include "audit/report.hpp"

namespace tamis::audit {

/// Asks for the intersections of every frame and for the contacts of every step between two frames. Frames are read
/// one after the other, in the calling thread, and are let go when they have been asked about; each thread asks about
/// runs of frames that follow each other. Frames that cannot be used are reported, and the rest is asked about.
/// Any exception of the source, or Cancelled, ends the audit: the report then holds the findings before it, and the
/// exception in Report::ended_by. Throws InvalidOptions.
Report audit(FrameSource& source, const Options& options);

}  // namespace tamis::audit
