// stdin, stdout and stderr as the caller left them: open, closed or full.
#pragma once

namespace tamis::cli {

/// To be called first. Opens each closed stream so that reading finds the end and writing fails. Otherwise the next
/// file that is opened would get the stream's number, and notes would be written into a result.
void occupy_standard_streams();

/// Flushes stdout; false if not all output arrived (a full disk, a closed stream).
bool flush_output();

}  // namespace tamis::cli
