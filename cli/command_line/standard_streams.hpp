// stdin, stdout and stderr as the caller left them: open, closed or full.
#pragma once

namespace tamis::cli {

/// To be called first. A closed stream would give its number to the next file that is opened, and notes would be
/// written into a result: closed ones are opened so that reading finds the end and writing fails.
void occupy_standard_streams();

/// Sends what was printed on its way; false if not all of it arrived (a full disk, a closed stream).
bool flush_output();

}  // namespace tamis::cli
