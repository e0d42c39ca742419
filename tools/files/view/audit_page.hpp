// The report of an audit as a page: a strip of all frames, and the frames that the report has kept, with their
// findings.
#pragma once
#include <filesystem>

#include "audit/report.hpp"

namespace tamis::io {

/// Of several topologies, shows the first one with a frame that is not free. Atomically. Throws FileError; also if the
/// report has kept no frame.
void write_audit_page(const std::filesystem::path& path, const audit::Report& report);

}  // namespace tamis::io
