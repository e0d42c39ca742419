// Prints the report of an audited motion, for people and as JSON.
#pragma once
#include "audit/report.hpp"
#include "command/report.hpp"

namespace tamis::cli {

/// `seconds`: from the first frame to the last.
void print_audit(const audit::Report& report, double seconds);
Json audit_json(const audit::Report& report, double seconds);
/// Prints the notes of frames on stderr, and if something was found, also why frames could not be asked about: then
/// this is no error.
void note_frames(const audit::Report& report);
/// Why some frames could not be asked about, in one sentence. REQUIRES: there are some.
std::string problem_of(const audit::Report& report);

}  // namespace tamis::cli
