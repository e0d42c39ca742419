// The report of an audit as a page: a strip of all frames, and those that the report has kept, with what was found.
#pragma once
#include <filesystem>

#include "audit/report.hpp"

namespace tamis::io {

/// Of several topologies the first one with something bad is shown. Atomically. Throws FileError; also if the report
/// has kept no frame.
void write_audit_page(const std::filesystem::path& path, const audit::Report& report);

}  // namespace tamis::io
