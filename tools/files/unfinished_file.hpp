// Files under temporary names, which must not outlive the process, on the signals that can be caught.
#pragma once
#include <sys/types.h>

#include <filesystem>

namespace tamis::io {

struct UnfinishedName;

/// A new file for writing, with a name of its own. The destructor removes it, or a signal that ends the process (see
/// remove_unfinished_files_on_signals), unless it got its final name before.
class UnfinishedFile {
 public:
  /// In `folder`; `mode` as for open(2). Throws std::system_error if it cannot be made.
  UnfinishedFile(const std::filesystem::path& folder, mode_t mode);
  ~UnfinishedFile();
  UnfinishedFile(const UnfinishedFile&) = delete;
  UnfinishedFile& operator=(const UnfinishedFile&) = delete;

  /// The caller closes it.
  int descriptor() const { return descriptor_; }
  /// Gives the file its final name, and replaces the file that had it. Throws std::system_error.
  void rename_to(const std::filesystem::path& path);

 private:
  UnfinishedName* name_;
  int descriptor_ = -1;
};

/// From now on SIGINT, SIGTERM, SIGHUP and the like remove the unfinished files before they end the process. A program
/// calls this at its start. Signals that are ignored (nohup) stay so; a file that grows too large (RLIMIT_FSIZE)
/// becomes an error of writing instead of a signal.
void remove_unfinished_files_on_signals();

}  // namespace tamis::io
