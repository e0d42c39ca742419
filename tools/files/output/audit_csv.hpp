// The report of an audit as tables.
#pragma once
#include <filesystem>

#include "audit/report.hpp"

namespace tamis::io {

/// One row a listed pair: frame, kind, v0, ..., v4, toi_lower, toi_upper, object_a, object_b, rings. `rings` is empty
/// where no path of edges leads from one feature to the other, and the limit plus one if the path is longer than the
/// limit. Names of objects are quoted. Atomically; throws FileError.
void write_audit_pairs_csv(const std::filesystem::path& path, const audit::Report& report);

/// One row a frame: frame, name, usable, step, vf, ee, ve, vv, ef, neighbours, toi_lower, toi_upper. Names are quoted.
void write_audit_frames_csv(const std::filesystem::path& path, const audit::Report& report);

}  // namespace tamis::io
