// A bar on stderr for work that takes long.
#pragma once
#include <chrono>
#include <cstddef>

namespace tamis::cli {

/// Shows itself only if stderr is a terminal, and only once the work has taken two seconds.
class Progress {
 public:
  Progress(std::size_t total, const char* unit);
  ~Progress() { clear(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void show(std::size_t done);
  /// To be called before anything else is printed.
  void clear();

 private:
  std::size_t total_;
  const char* unit_;
  bool is_terminal_;
  bool is_shown_ = false;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace tamis::cli
