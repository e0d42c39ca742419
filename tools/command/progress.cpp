#include "command/progress.hpp"

#include <fmt/format.h>

#include <string>

#include "command/command_line/messages.hpp"
#include "files/system.hpp"

namespace tamis::cli {

Progress::Progress(std::size_t total, const char* unit)
    : total_(total),
      unit_(unit),
      is_terminal_(system::stderr_is_terminal()),
      start_(std::chrono::steady_clock::now()) {}

void Progress::show(std::size_t done) {
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
  constexpr double kQuietSeconds = 2;
  if (!is_terminal_ || total_ == 0 || elapsed.count() < kQuietSeconds) return;
  constexpr std::size_t kWidth = 30;
  const std::size_t full = kWidth * done / total_;
  const double left = done == 0 ? 0 : elapsed.count() * static_cast<double>(total_ - done) / static_cast<double>(done);
  cli::show(fmt::format("\r[{}{}] {}/{} {}, {:.0f} s left\x1b[K", std::string(full, '#'),
                        std::string(kWidth - full, '.'), done, total_, unit_, left));
  is_shown_ = true;
}

void Progress::clear() {
  if (is_shown_) cli::show("\r\x1b[K");
  is_shown_ = false;
}

}  // namespace tamis::cli
